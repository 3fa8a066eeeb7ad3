#include "deck/sections/shapes/wall_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "cross_section/examination/mesh_examination.hpp"
#include "cross_section/walls/wall_mesh.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/sections/section_tables.hpp"
#include "deck/sections/shapes/section_materials.hpp"
#include "deck/text/table_files.hpp"
#include "mesh/sections/section_file.hpp"
#include "mesh/triangles/triangle_file.hpp"

namespace gxrod {
namespace {

WallOutline draw_walls(const WallsTable& given) {
    WallOutline outline{
        .corners = {}, .is_closed = given.closed.value_or(false), .line = given.line, .layups = {}};
    for (const CheckedCorner& corner : given.corners.corners)
        outline.corners.push_back({corner.corner.at, corner.corner.radius});
    outline.layups.resize(given.layup.names.size());
    std::iota(outline.layups.begin(), outline.layups.end(), 0);
    return outline;
}

// Adds a fault of walls at the corner or the layup that it is about.
void add_wall_fault(const WallsTable& given, const WallFault& fault, const BuildContext& context) {
    if (!fault.part.starts_with("corners")) return context.add_fault(given, given.layup, fault.message);
    Place place = given.corners.place;
    const std::size_t bracket = fault.part.find('[');
    if (bracket != std::string::npos)
        place = given.corners.corners[std::stoul(fault.part.substr(bracket + 1))].place;
    context.faults.add(place, given.path + "." + fault.part, fault.message);
}

std::vector<std::string> titles_of(const SurfaceMesh& file, int dimension) {
    std::vector<std::string> titles;
    for (const SurfaceGroup& group : file.groups) {
        if (group.dimension == dimension) titles.push_back(group.title());
    }
    return titles;
}

// Finds a physical group of a file; −1 if it has none.
int find_surface_group(const SurfaceMesh& file, int dimension, const std::string& name) {
    const auto found = std::ranges::find_if(file.groups, [&](const SurfaceGroup& group) {
        return group.dimension == dimension && group.title() == name;
    });
    return found == file.groups.end() ? -1 : static_cast<int>(found - file.groups.begin());
}

std::string explain_missing_group(const SurfaceMesh& file, int dimension, const std::string& name) {
    const std::vector<std::string> known = titles_of(file, dimension);
    const char* what = dimension == 2 ? "surfaces" : "curves";
    std::string hint = did_you_mean(name, known);
    if (hint.empty()) hint = known.empty() ? "; the file has none" : "; the file has " + plain_list(known);
    return fmt::format("no physical group \"{}\" of {} in the file{}", name, what, hint);
}

class GroupReader {
  public:
    GroupReader(const MeshShapeTable& given, const SurfaceMesh& file, const BuildContext& context)
        : given_(given), file_(file), context_(context), materials_(context) {}

    // Returns the layers of the section; nothing with a fault.
    std::optional<std::vector<SectionGroup>> read() {
        if (given_.material) {
            const auto material = materials_.find(name_of(given_, *given_.material));
            if (material) groups_.push_back({.name = "all", .material = *material});
            return material ? std::optional(groups_) : std::nullopt;
        }
        for (const MeshGroupTable& group : given_.groups.tables) read_group(group);
        check_all_have_materials();
        return is_complete_ ? std::optional(groups_) : std::nullopt;
    }
    const std::vector<ElasticMaterial>& materials() const { return materials_.materials(); }

  private:
    template <class T>
    static CheckedWord name_of(const T& table, const TableName& name) {
        return {name.word, table.place_of(&name), table.path_of(&name)};
    }

    void read_group(const MeshGroupTable& table) {
        const int group = find_surface_group(file_, 2, table.name);
        if (group < 0) add(table.place, table.path, explain_missing_group(file_, 2, table.name));
        const auto material = materials_.find(name_of(table, table.material));
        SectionGroup layer{.group = group, .name = table.name, .fibre_angle = table.angle.value_or(0.0)};
        if (table.direction) layer.wall = *table.direction;
        if (table.along) {
            const int curves = find_surface_group(file_, 1, *table.along);
            if (curves < 0)
                add(table.place_of(&table.along),
                    table.path_of(&table.along),
                    explain_missing_group(file_, 1, *table.along));
            layer.wall = curves;
        }
        if (table.directions) layer.wall = WallAngles{find_data(table)};
        is_complete_ = is_complete_ && material;
        layer.material = material.value_or(0);
        groups_.push_back(std::move(layer));
    }

    // Returns the index of element data; −1 with a fault.
    int find_data(const MeshGroupTable& table) {
        const auto found = std::ranges::find(file_.data, *table.directions, &SurfaceData::name);
        if (found != file_.data.end()) return static_cast<int>(found - file_.data.begin());
        std::vector<std::string> known;
        for (const SurfaceData& data : file_.data) known.push_back(data.name);
        add(table.place_of(&table.directions),
            table.path_of(&table.directions),
            fmt::format("no data \"{}\" of elements, one number each, in the file; {}",
                        *table.directions,
                        known.empty() ? "it has none" : "it has " + plain_list(known)));
        return -1;
    }

    void check_all_have_materials() {
        for (std::size_t i = 0; i < file_.groups.size(); ++i) {
            const SurfaceGroup& group = file_.groups[i];
            const auto is_it = [&](const SectionGroup& layer) { return layer.group == static_cast<int>(i); };
            if (group.dimension != 2 || std::ranges::any_of(groups_, is_it)) continue;
            add(given_.place_of(&given_.groups),
                given_.path_of(&given_.groups),
                fmt::format("the group \"{}\" of the file has no material here", group.title()));
        }
        const auto loose = std::ranges::count(file_.surfaces, -1, &SurfaceElement::group);
        if (loose > 0)
            add(given_.place_of(&given_.groups),
                given_.path_of(&given_.groups),
                fmt::format(
                    "{} of the file's {} surfaces are in no physical group", loose, file_.surfaces.size()));
    }

    void add(const Place& place, const std::string& path, const std::string& message) {
        context_.faults.add(place, path, message);
        is_complete_ = false;
    }

    const MeshShapeTable& given_;
    const SurfaceMesh& file_;
    const BuildContext& context_;
    SectionMaterials materials_;
    std::vector<SectionGroup> groups_;
    bool is_complete_ = true;
};

}  // namespace

std::optional<MeshedShape> mesh_walls_of(const WallsTable& given, const BuildContext& context) {
    SectionMaterials materials(context);
    std::vector<Layup> layups;
    for (const CheckedWord& name : given.layup.names) {
        std::optional<Layup> layup = materials.find_layup(name);
        if (layup) layups.push_back(std::move(*layup));
    }
    if (layups.size() != given.layup.names.size()) return std::nullopt;
    const WallOutline outline = draw_walls(given);
    if (const std::optional<WallFault> fault = find_fault(outline, layups)) {
        add_wall_fault(given, *fault, context);
        return std::nullopt;
    }
    return MeshedShape{"walls", mesh_walls(outline, layups), materials.materials()};
}

std::optional<MeshedShape> mesh_file_of(const MeshShapeTable& given,
                                        const SurfaceMesh& file,
                                        const BuildContext& context) {
    GroupReader reader(given, file, context);
    const std::optional<std::vector<SectionGroup>> groups = reader.read();
    if (!groups) return std::nullopt;
    std::string fault;
    try {
        MeshedShape shape{given.file, make_section_mesh(file, given.scale, *groups), reader.materials()};
        fault = find_mesh_fault(shape.mesh);
        if (fault.empty()) return shape;
    } catch (const MeshError& error) {
        fault = error.what();
    }
    context.add_fault(given, given.file, fmt::format("{}: {}", given.file, fault));
    return std::nullopt;
}

std::map<std::string, std::shared_ptr<const SurfaceMesh>> read_section_meshes(
    const CheckedTable& deck, const MeshFiles& files, FaultList& faults, std::vector<MeshRecord>& records) {
    std::map<std::string, std::shared_ptr<const SurfaceMesh>> meshes;
    for (const SectionTable& section : tables_of<SectionTable>(deck, section_table())) {
        if (!section.shape || !section.shape->mesh) continue;
        const MeshShapeTable& given = *section.shape->mesh;
        const std::filesystem::path path = files.find(given.file);
        try {
            meshes[section.name] = std::make_shared<const SurfaceMesh>(read_surface_mesh(path));
            keep_file(given.file, read_mesh_file(path), records);
        } catch (const MeshError& error) {
            faults.add(given.place_of(&given.file),
                       given.path_of(&given.file),
                       fmt::format("{}: {}", path.string(), error.what()));
        }
    }
    return meshes;
}

}  // namespace gxrod
