#include "check/findings/rod_straining.hpp"

#include <fmt/format.h>

namespace gxrod {

namespace {

// ∫ of the squares of Γ x y z and of the model's length times K x y z along a rod, from the chords between
// neighbouring nodes.
Vec6 integrate_strains(const std::vector<Vec6>& direction,
                       const Rod& rod,
                       const State& state,
                       double model_length) {
    Vec6 integral = Vec6::Zero();
    for (int entry = 0; entry + 1 < static_cast<int>(rod.element_nodes.size()); ++entry) {
        if ((entry + 1) % (rod.order + 1) == 0) continue;  // from an element to the next
        const int a = rod.element_nodes[entry];
        const int b = rod.element_nodes[entry + 1];
        const Vec3 chord = state.trial[b].r - state.trial[a].r;
        const double length = chord.norm();
        if (length == 0.0) continue;
        const Quat start = state.trial[a].Lambda * rod.triads[entry];
        const Quat end = state.trial[b].Lambda * rod.triads[entry + 1];
        const Quat to_section = start.slerp(0.5, end).conjugate();
        const Vec6 difference = direction[b] - direction[a];
        const Vec3 spin = 0.5 * (direction[a] + direction[b]).tail<3>();
        const Vec3 Gamma =
            to_section * Vec3(model_length * difference.head<3>() - spin.cross(chord)) / length;
        const Vec3 Kappa = model_length * (to_section * Vec3(difference.tail<3>())) / length;
        integral.head<3>() += length * Gamma.cwiseAbs2();
        integral.tail<3>() += length * Kappa.cwiseAbs2();
    }
    return integral;
}

int find_moving_node(const std::vector<Vec6>& direction, const Rod& rod) {
    int found = rod.nodes.front();
    for (const int node : rod.nodes) {
        // The first of equals, whatever their rounding.
        if (direction[node].norm() > (1.0 + 1e-9) * direction[found].norm()) found = node;
    }
    return found;
}

// A node's name without the name of its rod: "node 14"; points that decks can name keep theirs, "cable.end".
std::string name_in_rod(const std::string& node, const std::string& rod) {
    const std::string prefix = rod + " ";
    return node.starts_with(prefix) ? node.substr(prefix.size()) : node;
}

}  // namespace

std::string describe_straining(const std::vector<Vec6>& direction,
                               const ModelPart& part,
                               const System& system,
                               const State& state) {
    static constexpr const char* strains[6] = {
        "extension", "shear along y", "shear along z", "twist", "bending about y", "bending about z"};
    const Model& model = system.model();
    double largest = -1.0;
    int kind = 0;
    const Rod* strained = nullptr;
    for (const int index : part.rods) {
        const Rod& rod = model.rods[index];
        int component = 0;
        const double strain =
            integrate_strains(direction, rod, state, system.length_scale()).maxCoeff(&component);
        if (strain <= largest) continue;
        largest = strain;
        kind = component;
        strained = &rod;
    }
    const int node = find_moving_node(direction, *strained);
    return fmt::format(
        "rod {}, {}: {}", strained->name, name_in_rod(model.nodes[node].name, strained->name), strains[kind]);
}

}  // namespace gxrod
