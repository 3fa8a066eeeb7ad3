#include "tools/rod_models.hpp"

#include <algorithm>

#include "numerics/lagrange.hpp"

namespace gxrod::tools {

namespace {

std::vector<double> find_node_positions(int order) {
    const auto copy = [](const auto& at) { return std::vector<double>(at.begin(), at.end()); };
    switch (order) {
        case 1:
            return copy(compute_node_positions<2>());
        case 2:
            return copy(compute_node_positions<3>());
        case 3:
            return copy(compute_node_positions<4>());
        default:
            return copy(compute_node_positions<5>());
    }
}

}  // namespace

Placement along_x(double s) { return {Vec3(s, 0.0, 0.0), Quat::Identity()}; }

Section make_section(const std::array<double, 6>& stiffness, const std::array<double, 6>& mass) {
    Section section;
    section.name = "tube";
    section.stiffness.diagonal() = Vec6(stiffness.data());
    section.mass.diagonal() = Vec6(mass.data());
    return section;
}

Model make_rod_model(const Line& line, double length, const Mesh& mesh, const Section& section) {
    Model model;
    model.sections.push_back(section);
    Rod rod;
    rod.name = "rod";
    rod.kind = mesh.kind;
    rod.order = mesh.order;
    const std::vector<double> at = find_node_positions(mesh.order);
    std::vector<double> arc_length;
    std::vector<Quat> triads;
    for (int e = 0; e < mesh.elements; ++e) {
        for (int i = e == 0 ? 0 : 1; i <= mesh.order; ++i) {
            const double s = length * (e + 0.5 * (1.0 + at[i])) / mesh.elements;
            const int node = static_cast<int>(model.nodes.size());
            model.nodes.push_back({"rod node " + std::to_string(node), line(s).r});
            rod.nodes.push_back(node);
            arc_length.push_back(s);
            triads.push_back(line(s).axes);
        }
    }
    set_line_elements(rod, arc_length, triads);
    model.rods.push_back(rod);
    return model;
}

void clamp(Model& model, int node) {
    model.supports.push_back({.node = node, .fixed = {true, true, true, true, true, true}});
}

void add_ramp(Model& model, int node, const Vec3& force, const Vec3& moment, Frame frame) {
    NodalLoad load;
    load.node = node;
    load.frame = frame;
    const Rod& rod = model.rods[0];
    const auto at = std::find(rod.nodes.begin(), rod.nodes.end(), node);
    load.axes = rod.triad_at(static_cast<int>(at - rod.nodes.begin()));
    for (int i = 0; i < 3; ++i) {
        load.force[i] = ramp(force[i]);
        load.moment[i] = ramp(moment[i]);
    }
    model.loads.push_back(load);
}

}  // namespace gxrod::tools
