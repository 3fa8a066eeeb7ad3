#include "results/tables/frame_mesh.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace gxrod {
namespace {

constexpr std::uint8_t vtk_vertex = 1;
// Line, quadratic edge, Lagrange curve; by order. Not the cubic line (35): when VTK subdivides it, it folds
// back, since its parameter runs from −1 to 1 where VTK takes 0 to 1.
constexpr std::array<std::uint8_t, 5> vtk_curve{0, 3, 21, 68, 68};

void add_cell(FrameMesh& mesh, std::uint8_t type, double radius) {
    mesh.offsets.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
    mesh.types.push_back(type);
    mesh.cell_radius.push_back(radius);
}

// VTK wants the two ends first, then the nodes between them.
void add_rod(FrameMesh& mesh, const Rod& rod, double radius) {
    assert(rod.order >= 1 && rod.order <= 4);
    const auto order = static_cast<std::size_t>(rod.order);
    for (std::size_t first = 0; first < rod.element_nodes.size(); first += order + 1) {
        mesh.connectivity.push_back(rod.element_nodes[first]);
        mesh.connectivity.push_back(rod.element_nodes[first + order]);
        for (std::size_t i = 1; i < order; ++i) mesh.connectivity.push_back(rod.element_nodes[first + i]);
        add_cell(mesh, vtk_curve[order], radius);
    }
}

double rod_radius(const Model& model, const Rod& rod) {
    return equivalent_radius(model.sections[static_cast<std::size_t>(rod.section)]);
}

std::vector<double> node_radii(const Model& model) {
    std::vector<double> radii(model.nodes.size(), 0.0);
    // Later ones overwrite: the first rod wins.
    for (auto rod = model.rods.rbegin(); rod != model.rods.rend(); ++rod) {
        for (const int node : rod->element_nodes)
            radii[static_cast<std::size_t>(node)] = rod_radius(model, *rod);
    }
    return radii;
}

std::vector<Quat> node_triads(const Model& model) {
    std::vector<Quat> triads(model.nodes.size(), Quat::Identity());
    // Later ones overwrite: rods win over bodies, the first of each kind over the next.
    for (auto body = model.bodies.rbegin(); body != model.bodies.rend(); ++body) {
        triads[static_cast<std::size_t>(body->node)] = body->attitude;
    }
    for (auto rod = model.rods.rbegin(); rod != model.rods.rend(); ++rod) {
        for (std::size_t i = rod->element_nodes.size(); i-- > 0;) {
            triads[static_cast<std::size_t>(rod->element_nodes[i])] = rod->triads[i];
        }
    }
    return triads;
}

}  // namespace

FrameMesh make_frame_mesh(const Model& model) {
    FrameMesh mesh;
    for (const Rod& rod : model.rods) add_rod(mesh, rod, rod_radius(model, rod));
    for (const Body& body : model.bodies) {
        mesh.connectivity.push_back(body.node);
        add_cell(mesh, vtk_vertex, 0.0);
    }
    // add_cell notes where a cell ends; the first begins at 0.
    mesh.offsets.insert(mesh.offsets.begin(), 0);
    mesh.point_radius = node_radii(model);
    mesh.triads = node_triads(model);
    return mesh;
}

double equivalent_radius(const Section& section) {
    const double EA = section.stiffness(0, 0);
    const double EI = 0.5 * (section.stiffness(4, 4) + section.stiffness(5, 5));
    const double radius = 2.0 * std::sqrt(EI / EA);
    return std::isfinite(radius) ? radius : 0.0;
}

}  // namespace gxrod
