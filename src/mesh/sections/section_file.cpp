#include "mesh/sections/section_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "mesh/sections/element_walls.hpp"
#include "mesh/sections/surface_cells.hpp"
#include "mesh/sections/wall_directions.hpp"

namespace gxrod {
namespace {

// Nodes are in a plane if they are no farther from it than this, over the extent of the mesh.
constexpr double plane_tolerance = 1e-9;

// Returns the nodes in the plane of the section.
std::vector<PlanePoint> flatten(const SurfaceMesh& mesh, double scale) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const SurfaceElement& element : mesh.surfaces) {
        for (const int node : element.nodes) {
            low = low.cwiseMin(mesh.positions[static_cast<std::size_t>(node)]);
            high = high.cwiseMax(mesh.positions[static_cast<std::size_t>(node)]);
        }
    }
    const Vec3 extent = high - low;
    const double tolerance = plane_tolerance * extent.maxCoeff();
    int first = 0;
    if (extent.z() > tolerance) {
        if (extent.x() > tolerance)
            throw MeshError(
                "is not a section: its surfaces lie neither in a plane z = constant nor in x = constant");
        first = 1;
    }
    std::vector<PlanePoint> nodes;
    for (const Vec3& position : mesh.positions) nodes.emplace_back(scale * position.segment<2>(first));
    return nodes;
}

// Leaves out nodes that no cell has.
void drop_unused_nodes(SectionMesh& mesh) {
    std::vector<int> numbers(mesh.nodes.size(), -1);
    std::vector<PlanePoint> nodes;
    for (SectionCell& cell : mesh.cells) {
        for (int& node : cell.nodes) {
            int& number = numbers[static_cast<std::size_t>(node)];
            if (number < 0) {
                number = static_cast<int>(nodes.size());
                nodes.push_back(mesh.nodes[static_cast<std::size_t>(node)]);
            }
            node = number;
        }
    }
    mesh.nodes = std::move(nodes);
}

// Gives cells their wall directions, each node's computed once.
class WallPainter {
  public:
    WallPainter(const SurfaceMesh& mesh, const std::vector<PlanePoint>& file_nodes)
        : mesh_(mesh), file_nodes_(file_nodes) {}

    // The cell is that of a surface of the file.
    void paint(const SectionGroup& layer,
               std::size_t surface,
               const std::vector<PlanePoint>& nodes,
               SectionCell& cell) {
        if (const double* angle = std::get_if<double>(&layer.wall)) {
            if (*angle != 0.0) paint_by_angle(*angle, cell);
        } else if (const auto* angles = std::get_if<WallAngles>(&layer.wall)) {
            paint_by_data(mesh_, surface, mesh_.data[static_cast<std::size_t>(angles->data)], cell);
        } else {
            paint_along(std::get<int>(layer.wall), nodes, cell);
        }
    }

  private:
    void paint_along(int group, const std::vector<PlanePoint>& nodes, SectionCell& cell) {
        const auto found = directions_.try_emplace(group, mesh_, group, file_nodes_).first;
        auto& known = known_[group];
        for (const int node : cell.nodes) {
            const auto [place, is_new] = known.try_emplace(node);
            if (is_new) place->second = found->second.at(nodes[static_cast<std::size_t>(node)]);
            cell.walls.push_back(place->second);
        }
    }

    const SurfaceMesh& mesh_;
    const std::vector<PlanePoint>& file_nodes_;
    std::map<int, WallDirections> directions_;
    std::map<int, std::map<int, PlanePoint>> known_;
};

}  // namespace

SectionMesh make_section_mesh(const SurfaceMesh& mesh,
                              double scale,
                              const std::vector<SectionGroup>& groups) {
    if (mesh.surfaces.empty()) throw MeshError("has no surfaces; expected triangles or quadrangles");
    const std::vector<PlanePoint> file_nodes = flatten(mesh, scale);
    SectionMesh section;
    section.nodes = file_nodes;
    for (const SectionGroup& group : groups)
        section.layers.push_back({group.name, group.material, group.fibre_angle});
    SurfaceCells cells(section);
    WallPainter painter(mesh, file_nodes);
    for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
        const SurfaceElement& element = mesh.surfaces[i];
        const auto found = std::ranges::find_if(groups, [&](const SectionGroup& group) {
            return group.group == -1 || group.group == element.group;
        });
        if (found == groups.end()) continue;
        section.cells.push_back(cells.make(element, static_cast<int>(found - groups.begin())));
        painter.paint(*found, i, section.nodes, section.cells.back());
    }
    drop_unused_nodes(section);
    return section;
}

}  // namespace gxrod
