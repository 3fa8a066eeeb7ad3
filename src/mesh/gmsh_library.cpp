#include "mesh/gmsh_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <string>

#include "machine/child_process.hpp"
#include "mesh/line_mesh.hpp"

namespace gxrod {
namespace {

template <class Function>
void find_function(void* library, const char* name, Function*& function) {
    void* address = dlsym(library, name);
    if (address == nullptr) throw MeshError(fmt::format("libgmsh has no function {}", name));
    function = reinterpret_cast<Function*>(address);
}

// Never closed: its destructors run at the end of the program. Nothing, with the reason, if none is found.
void* open_library(std::span<const char* const> names, std::string& reason) {
    for (const char* name : names) {
        if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
        if (reason.empty()) reason = dlerror();
    }
    return nullptr;
}

bool is_for_want_of_memory(const std::string& reason) {
    return reason.find("failed to map") != std::string::npos ||
           reason.find("annot allocate") != std::string::npos ||
           reason.find("cannot create") != std::string::npos;
}

// Some of the ninety libraries that come with it crash when memory is short: so another
// process tries first.
void try_to_load(std::span<const char* const> names) {
    constexpr int most_seconds = 60;
    std::string reason;
    try {
        reason = run_in_child(
            [&] {
                std::string why;
                open_library(names, why);
                return why;
            },
            {.processor_seconds = most_seconds});
    } catch (const ChildError& error) {
        throw MeshError(
            fmt::format("libgmsh cannot be loaded, perhaps for lack of memory: {}", error.what()));
    }
    if (is_for_want_of_memory(reason)) throw MeshError("there is no memory for libgmsh: " + reason);
}

}  // namespace

GmshLibrary load_gmsh(std::span<const char* const> names) {
    try_to_load(names);
    std::string reason;
    void* library = open_library(names, reason);
    if (library == nullptr) {
        throw MeshError(fmt::format(
            "meshing and reading meshes need libgmsh: apt install libgmsh4.8 on Debian 12, libgmsh4.13 on "
            "Debian 13 ({})",
            reason));
    }
    GmshLibrary gmsh{};
    find_function(library, "gmshInitialize", gmsh.initialize);
    find_function(library, "gmshFinalize", gmsh.finalize);
    find_function(library, "gmshOpen", gmsh.open);
    find_function(library, "gmshOptionSetNumber", gmsh.set_number);
    find_function(library, "gmshModelMeshGenerate", gmsh.generate);
    find_function(library, "gmshFree", gmsh.release);
    find_function(library, "gmshLoggerStart", gmsh.start_log);
    find_function(library, "gmshLoggerStop", gmsh.stop_log);
    find_function(library, "gmshLoggerGet", gmsh.get_log);
    find_function(library, "gmshModelGetPhysicalGroups", gmsh.get_groups);
    find_function(library, "gmshModelGetPhysicalName", gmsh.get_group_name);
    find_function(library, "gmshModelGetEntitiesForPhysicalGroup", gmsh.get_group_entities);
    find_function(library, "gmshModelMeshGetNodesForPhysicalGroup", gmsh.get_group_nodes);
    find_function(library, "gmshModelMeshGetNodes", gmsh.get_nodes);
    find_function(library, "gmshModelMeshGetElements", gmsh.get_elements);
    find_function(library, "gmshViewGetTags", gmsh.get_views);
    find_function(library, "gmshViewGetModelData", gmsh.get_view_data);
    find_function(library, "gmshOptionGetString", gmsh.get_text);
    find_function(library, "gmshModelAdd", gmsh.add_model);
    find_function(library, "gmshModelGeoAddPoint", gmsh.add_point);
    find_function(library, "gmshModelGeoAddLine", gmsh.add_line);
    find_function(library, "gmshModelGeoAddCurveLoop", gmsh.add_curve_loop);
    find_function(library, "gmshModelGeoAddPlaneSurface", gmsh.add_plane_surface);
    find_function(library, "gmshModelGeoSynchronize", gmsh.synchronize);
    find_function(library, "gmshModelMeshSetTransfiniteCurve", gmsh.set_curve_nodes);
    return gmsh;
}

const GmshLibrary& gmsh_library() {
    static constexpr std::array names{
        "libgmsh.so.4.8", "libgmsh.so.4.12", "libgmsh.so.4.13", "libgmsh.so.4", "libgmsh.so"};
    static const GmshLibrary library = load_gmsh(names);
    return library;
}

}  // namespace gxrod
