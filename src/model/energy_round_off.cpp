#include "model/energy_round_off.hpp"

#include <algorithm>
#include <limits>

namespace gxrod {
namespace {

// Relative, of a position or rotation that many operations have made.
constexpr double round_off = 16.0 * std::numeric_limits<double>::epsilon();

double compute_element_energy(const Mat6& stiffness, double size, double length) {
    const double displacement = round_off * size;
    const double stretching = stiffness.diagonal().head<3>().maxCoeff() * displacement * displacement;
    const double bending = stiffness.diagonal().tail<3>().maxCoeff() * round_off * round_off;
    return 0.5 * (stretching + bending) / length;
}

bool moves_supports(const Model& model) {
    return std::any_of(model.supports.begin(), model.supports.end(), [](const Support& support) {
        return support.moved != std::array<bool, 6>{};
    });
}

// The work of reactions that are round-off, in a motion of about the length of an element or a radian.
// `stiffness`: force per strain of a rod, force per length of a spring.
double compute_reaction_work(double stiffness, double size) {
    constexpr double of_a_reaction = 4.0 * std::numeric_limits<double>::epsilon();
    return of_a_reaction * stiffness * size;
}

}  // namespace

double compute_energy_round_off(const Model& model) {
    double size = 0.0;
    for (const Node& node : model.nodes) {
        size = std::max(size, node.position.lpNorm<Eigen::Infinity>());
    }
    double energy = 0.0;
    double work = 0.0;
    const bool has_moves = moves_supports(model);
    for (const Rod& rod : model.rods) {
        const Mat6& stiffness = model.sections[static_cast<std::size_t>(rod.section)].stiffness;
        if (has_moves)
            work = std::max(work, compute_reaction_work(stiffness.diagonal().head<3>().maxCoeff(), size));
        const auto per_element = static_cast<std::size_t>(rod.order) + 1;
        for (std::size_t first = 0; first < rod.arc_length.size(); first += per_element) {
            const double length = rod.arc_length[first + per_element - 1] - rod.arc_length[first];
            energy += compute_element_energy(stiffness, size, length);
        }
    }
    for (const Spring& spring : model.springs) {
        const double stiffness = find_stiffness(spring);
        const double displacement = round_off * std::max(size, spring.length);
        energy += 0.5 * stiffness * displacement * displacement;
        if (has_moves) work = std::max(work, compute_reaction_work(stiffness * size, size));
    }
    for (const Bushing& bushing : model.bushings) {
        energy += compute_element_energy(bushing.stiffness, size, 1.0);
        const double stiffness = bushing.stiffness.diagonal().head<3>().maxCoeff();
        if (has_moves) work = std::max(work, compute_reaction_work(stiffness * size, size));
    }
    return energy + work;
}

}  // namespace gxrod
