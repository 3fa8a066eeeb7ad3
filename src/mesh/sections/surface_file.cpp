#include "mesh/sections/surface_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string_view>
#include <unordered_map>

#include "machine/child_process.hpp"
#include "mesh/gmsh_session.hpp"
#include "mesh/triangles/triangle_file.hpp"

namespace gxrod {
namespace {

using NodeNumbers = std::unordered_map<std::size_t, int>;  // from Gmsh's numbers

// The nodes of types of elements, as the MSH format numbers types.
std::size_t count_element_nodes(int type) {
    static const std::map<int, std::size_t> counts{
        {1, 2}, {8, 3}, {26, 4}, {2, 3}, {9, 6}, {21, 10}, {3, 4}, {16, 8}, {10, 9}, {36, 16}};
    const auto found = counts.find(type);
    if (found == counts.end()) {
        throw MeshError(
            fmt::format("has elements of type {}; expected triangles of 3, 6 or 10 nodes and quadrangles of "
                        "4, 8, 9 or 16",
                        type));
    }
    return found->second;
}

std::vector<SurfaceElement> split_elements(const std::vector<GmshElements>& all,
                                           int group,
                                           const NodeNumbers& numbers) {
    std::vector<SurfaceElement> elements;
    for (const GmshElements& some : all) {
        const std::size_t count = count_element_nodes(some.type);
        for (std::size_t first = 0; first + count <= some.nodes.size(); first += count) {
            elements.push_back({.type = some.type, .group = group});
            elements.back().number = some.numbers[first / count];
            for (std::size_t i = 0; i < count; ++i)
                elements.back().nodes.push_back(numbers.at(some.nodes[first + i]));
        }
    }
    return elements;
}

// Adds surfaces once each, whatever the number of times that the file has them.
class SurfaceCollector {
  public:
    explicit SurfaceCollector(SurfaceMesh& mesh) : mesh_(mesh) {}

    void add(SurfaceElement element) {
        std::vector<int> key = element.nodes;
        std::ranges::sort(key);
        const auto [found, is_new] = known_.emplace(std::move(key), mesh_.surfaces.size());
        if (is_new) {
            mesh_.surfaces.push_back(std::move(element));
            return;
        }
        int& group = mesh_.surfaces[found->second].group;
        if (element.group < 0 || group == element.group) return;
        if (group >= 0) throw MeshError(describe_conflict(element, group));
        group = element.group;
    }

  private:
    std::string describe_conflict(const SurfaceElement& element, int other) const {
        const Vec3& at = mesh_.positions[static_cast<std::size_t>(element.nodes.front())];
        const auto title = [&](int group) { return mesh_.groups[static_cast<std::size_t>(group)].title(); };
        return fmt::format(
            "the surface at ({:.4g}, {:.4g}, {:.4g}) is in two groups, \"{}\" and \"{}\"; expected one",
            at.x(),
            at.y(),
            at.z(),
            title(other),
            title(element.group));
    }

    SurfaceMesh& mesh_;
    std::map<std::vector<int>, std::size_t> known_;
};

// Finds the values of each surface.
SurfaceData spread_data(GmshSession::ElementData&& given, const std::vector<SurfaceElement>& surfaces) {
    std::unordered_map<std::size_t, std::size_t> places;
    for (std::size_t i = 0; i < given.numbers.size(); ++i) places[given.numbers[i]] = i;
    SurfaceData data{std::move(given.name), {}};
    for (const SurfaceElement& surface : surfaces) {
        const auto found = places.find(surface.number);
        data.values.push_back(found == places.end() ? std::vector<double>{}
                                                    : std::move(given.values[found->second]));
    }
    return data;
}

SurfaceMesh read_surfaces_with_gmsh(const GmshLibrary& gmsh, const std::filesystem::path& file) {
    GmshSession session(gmsh);
    session.open(file);
    GmshSession::Nodes nodes = session.nodes();
    NodeNumbers numbers;
    for (std::size_t i = 0; i < nodes.numbers.size(); ++i) numbers[nodes.numbers[i]] = static_cast<int>(i);
    SurfaceMesh mesh;
    mesh.positions = std::move(nodes.positions);
    SurfaceCollector surfaces(mesh);
    for (const GmshSession::Group& group : session.groups()) {
        if (group.dimension != 1 && group.dimension != 2) continue;
        const int index = static_cast<int>(mesh.groups.size());
        mesh.groups.push_back({group.dimension, group.number, group.name});
        for (SurfaceElement& element : split_elements(session.elements_of(group), index, numbers)) {
            if (group.dimension == 2) {
                surfaces.add(std::move(element));
            } else {
                mesh.curves.push_back(std::move(element));
            }
        }
    }
    for (SurfaceElement& element : split_elements(session.elements_of_entity(2, -1), -1, numbers))
        surfaces.add(std::move(element));
    for (GmshSession::ElementData& data : session.element_data())
        mesh.data.push_back(spread_data(std::move(data), mesh.surfaces));
    return mesh;
}

// A mesh as bytes, for the way from another process; numbers follow each other as they are.
class SurfaceWriter {
  public:
    template <class Number>
    void add(Number number) {
        bytes.append(reinterpret_cast<const char*>(&number), sizeof(Number));
    }
    void add(const std::vector<SurfaceElement>& elements) {
        add(elements.size());
        for (const SurfaceElement& element : elements) {
            add(element.type);
            add(element.group);
            add(element.number);
            add(element.nodes.size());
            for (const int node : element.nodes) add(node);
        }
    }
    void add(const std::string& text) {
        add(text.size());
        bytes += text;
    }
    void add(const std::vector<double>& values) {
        add(values.size());
        for (const double value : values) add(value);
    }

    std::string bytes;
};

class SurfaceReader {
  public:
    explicit SurfaceReader(std::string_view bytes) : rest_(bytes) {}

    template <class Number>
    Number get() {
        Number number;
        std::memcpy(&number, take(sizeof(Number)).data(), sizeof(Number));
        return number;
    }
    std::string_view take(std::size_t count) {
        if (count > rest_.size()) throw MeshError("what was read of it is cut short");
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    std::vector<SurfaceElement> elements() {
        std::vector<SurfaceElement> elements(get<std::size_t>());
        for (SurfaceElement& element : elements) {
            element.type = get<int>();
            element.group = get<int>();
            element.number = get<std::size_t>();
            element.nodes.resize(get<std::size_t>());
            for (int& node : element.nodes) node = get<int>();
        }
        return elements;
    }
    std::string text() { return std::string(take(get<std::size_t>())); }
    std::vector<double> values() {
        std::vector<double> values(get<std::size_t>());
        for (double& value : values) value = get<double>();
        return values;
    }

  private:
    std::string_view rest_;
};

std::string write_surface_bytes(const SurfaceMesh& mesh) {
    SurfaceWriter writer;
    writer.add(mesh.positions.size());
    for (const Vec3& position : mesh.positions) {
        for (int i = 0; i < 3; ++i) writer.add(position[i]);
    }
    writer.add(mesh.groups.size());
    for (const SurfaceGroup& group : mesh.groups) {
        writer.add(group.dimension);
        writer.add(group.number);
        writer.add(group.name);
    }
    writer.add(mesh.surfaces);
    writer.add(mesh.curves);
    writer.add(mesh.data.size());
    for (const SurfaceData& data : mesh.data) {
        writer.add(data.name);
        for (const std::vector<double>& values : data.values) writer.add(values);
    }
    return std::move(writer.bytes);
}

SurfaceMesh read_surface_bytes(std::string_view bytes) {
    SurfaceReader reader(bytes);
    SurfaceMesh mesh;
    mesh.positions.resize(reader.get<std::size_t>());
    for (Vec3& position : mesh.positions) {
        for (int i = 0; i < 3; ++i) position[i] = reader.get<double>();
    }
    mesh.groups.resize(reader.get<std::size_t>());
    for (SurfaceGroup& group : mesh.groups) {
        group.dimension = reader.get<int>();
        group.number = reader.get<int>();
        group.name = reader.text();
    }
    mesh.surfaces = reader.elements();
    mesh.curves = reader.elements();
    mesh.data.resize(reader.get<std::size_t>());
    for (SurfaceData& data : mesh.data) {
        data.name = reader.text();
        for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) data.values.push_back(reader.values());
    }
    return mesh;
}

constexpr char has_surfaces = 's';
constexpr char has_reason = 'e';

std::string answer_surfaces(const GmshLibrary& gmsh, const std::filesystem::path& file) {
    try {
        return has_surfaces + write_surface_bytes(read_surfaces_with_gmsh(gmsh, file));
    } catch (const MeshError& error) {
        return has_reason + std::string(error.what());
    } catch (const std::out_of_range&) {
        return has_reason + std::string("an element has a node that the mesh lacks");
    }
}

}  // namespace

// In a process of its own, as line meshes are.
SurfaceMesh read_surface_mesh(const std::filesystem::path& file) {
    if (const std::string start = read_mesh_file(file).substr(0, 20);
        !start.starts_with("$MeshFormat") && !start.starts_with("$NOD") && !start.starts_with("$Comments"))
        throw MeshError("is no mesh; a .msh file starts with $MeshFormat");
    const GmshLibrary& gmsh = gmsh_library();
    std::string said;
    try {
        said = run_in_child([&] { return answer_surfaces(gmsh, file); },
                            {.processor_seconds = 600, .waiting_seconds = 30, .reads_only = true});
    } catch (const ChildError& error) {
        throw MeshError(std::string("Gmsh cannot read it: ") + error.what());
    }
    if (said.empty() || said[0] != has_surfaces)
        throw MeshError(said.empty() ? "Gmsh gives nothing" : said.substr(1));
    return read_surface_bytes(std::string_view(said).substr(1));
}

}  // namespace gxrod
