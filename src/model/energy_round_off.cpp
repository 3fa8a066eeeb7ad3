#include "model/energy_round_off.hpp"

#include <algorithm>
#include <limits>

#include "model/ties/ties.hpp"

namespace gxrod {
namespace {

// Relative, of a position or rotation that many operations have made.
constexpr double round_off = 16.0 * std::numeric_limits<double>::epsilon();

double compute_element_energy(const TieStiffness& stiffness, double size) {
    const double displacement = round_off * size;
    const double stretching = stiffness.displacement * displacement * displacement;
    const double bending = stiffness.turn * round_off * round_off;
    return 0.5 * (stretching + bending);
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
        const auto diagonal = model.sections[static_cast<std::size_t>(rod.section)].stiffness.diagonal();
        const TieStiffness stiffness{.displacement = diagonal.head<3>().maxCoeff(),
                                     .turn = diagonal.tail<3>().maxCoeff()};
        if (has_moves) work = std::max(work, compute_reaction_work(stiffness.displacement, size));
        const auto per_element = static_cast<std::size_t>(rod.order) + 1;
        for (std::size_t first = 0; first < rod.arc_length.size(); first += per_element) {
            const double length = rod.arc_length[first + per_element - 1] - rod.arc_length[first];
            energy += compute_element_energy(stiffness, size) / length;
        }
    }
    for_each_element_tie(model, [&](TieKind, const auto& tie) {
        const TieStiffness stiffness = stiffness_of(tie);
        energy += compute_element_energy(stiffness, std::max(size, stiffness.length));
        if (has_moves) work = std::max(work, compute_reaction_work(stiffness.displacement * size, size));
    });
    return energy + work;
}

}  // namespace gxrod
