#include "results/stresses/cross_section_table.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>

#include "cross_section/cross_section.hpp"

namespace gxrod {
namespace {

// The corners of a cell among its nodes, anticlockwise.
std::vector<std::size_t> find_corners(const SectionCell& cell) {
    const auto p = static_cast<std::size_t>(cell.order);
    if (cell.shape == CellShape::triangle) return {0, p, cell.nodes.size() - 1};
    return {0, p, cell.nodes.size() - 1, p * (p + 1)};
}

bool has_quads(const SectionMesh& mesh) {
    return std::ranges::any_of(mesh.cells,
                               [](const SectionCell& cell) { return cell.shape == CellShape::quad; });
}

// A number of each corner of each cell; `of_node` takes the cell and the index of one of its nodes.
template <class OfNode>
void write_corners(const Hdf5Handle& group,
                   const DatasetLabel& label,
                   const SectionMesh& mesh,
                   const OfNode& of_node) {
    const std::size_t columns = has_quads(mesh) ? 4 : 3;
    std::vector<std::int64_t> values;
    for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
        std::vector<std::size_t> corners = find_corners(mesh.cells[i]);
        corners.resize(columns, corners.back());
        for (const std::size_t corner : corners) values.push_back(of_node(i, corner));
    }
    write_dataset(group, label, std::array<hsize_t, 2>{mesh.cells.size(), columns}, values);
}

// "carbon 45°", the name of a material, and what angle the fibres have.
std::string describe_layer(const SectionLayer& layer, const CrossSection& section) {
    const std::string& material = section.materials[static_cast<std::size_t>(layer.material)].name;
    const std::string& name = material.empty() ? layer.name : material;
    if (layer.fibre_angle == 0.0) return name;
    return fmt::format("{} {:.4g}°", name, layer.fibre_angle * 180.0 / std::numbers::pi);
}

void write_points(const Hdf5Handle& group, const std::string& name, std::span<const PlanePoint> points) {
    const bool is_node = name == "nodes";
    std::vector<double> values;
    for (const PlanePoint& point : points) values.insert(values.end(), {point.x(), point.y()});
    write_dataset(
        group,
        {name,
         is_node ? "(y, z) of the nodes of the cells" : "(y, z) of the points where stresses are known",
         "material",
         "length"},
        std::array<hsize_t, 2>{points.size(), 2},
        std::span<const double>(values));
}

void write_stresses(const Hdf5Handle& group, const CrossSection& section) {
    std::vector<PlanePoint> points;
    std::vector<std::int64_t> layers;
    std::vector<std::uint8_t> singular;
    std::vector<float> operators;
    for (const StressPoint& point : section.stresses.points) {
        points.push_back(point.at);
        layers.push_back(point.layer);
        singular.push_back(point.is_singular ? 1 : 0);
        for (int row = 0; row < 6; ++row) {
            for (int column = 0; column < 6; ++column)
                operators.push_back(static_cast<float>(point.stress_operator(row, column)));
        }
    }
    write_points(group, "points", points);
    write_dataset(
        group, {"point_layer", "layer of each point", "none", "1"}, std::span<const std::int64_t>(layers));
    write_dataset(
        group,
        {"is_singular", "1 near sharp corners, where stress has no bound: no part in the worst", "none", "1"},
        std::span<const std::uint8_t>(singular));
    write_compressed(group,
                     {"stress_operator",
                      "6 × 6, row by row: stresses xx yy zz yz xz xy from N Vy Vz T My Mz, at each point",
                      "material",
                      "1/length²; 1/length³"},
                     36,
                     operators);
}

void write_cross_section(const Hdf5Handle& group, const ListedShape& listed) {
    const CrossSection& section = *listed.shape;
    const SectionMesh& mesh = section.mesh;
    write_attribute(group.id(), "name", listed.name);
    write_attribute(group.id(), "source", section.source);
    write_points(group, "nodes", mesh.nodes);
    write_corners(group,
                  {"cells", "nodes at the corners of each cell, anticlockwise", "none", "1"},
                  mesh,
                  [&](std::size_t cell, std::size_t node) { return mesh.cells[cell].nodes[node]; });
    write_corners(
        group,
        {"cell_points", "points at the corners of each cell", "none", "1"},
        mesh,
        [&](std::size_t cell, std::size_t node) { return section.stresses.points_of_cells[cell][node]; });
    std::vector<std::int64_t> layers;
    for (const SectionCell& cell : mesh.cells) layers.push_back(cell.layer);
    write_dataset(group, {"layer", "layer of each cell", "none", "1"}, std::span<const std::int64_t>(layers));
    std::vector<std::string> names;
    for (const SectionLayer& layer : mesh.layers) names.push_back(describe_layer(layer, section));
    write_dataset(group,
                  {"layers", "material of each layer, with the angle of its fibres", "none", ""},
                  std::span<const std::string>(names));
    write_stresses(group, section);
}

}  // namespace

void write_cross_sections(const Hdf5Handle& root, const std::vector<ListedShape>& shapes) {
    if (has_link(root, "sections")) return;
    const Hdf5Handle group = require_group(root, "sections");
    std::vector<std::string> names;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        names.push_back(shapes[i].name);
        write_cross_section(require_group(group, std::to_string(i)), shapes[i]);
    }
    write_dataset(
        group,
        {"name", "of each section, and where along a rod one that varies has this shape", "none", ""},
        std::span<const std::string>(names));
}

}  // namespace gxrod
