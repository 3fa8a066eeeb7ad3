#include "solvers/pseudo_step.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

constexpr double arm_of_length = 0.1;
// What one radian of bending, spread over a rod, is resisted by: of the displacement of all nodes by the
// length of the part.
constexpr double bending_of_length = 0.1;

Vec3 find_turn(const NodeMotion& from, const NodeMotion& to) {
    return log_nearest(to.Lambda * from.Lambda.conjugate(), Vec3::Zero());
}

}  // namespace

PseudoDrag::PseudoDrag(const System& system)
    : system_(&system), share_(1.0 / static_cast<double>(system.equations().node_count())) {
    turning_.resize(system.equations().node_count());
    for (std::size_t node = 0; node < turning_.size(); ++node) {
        const double arm = arm_of_length * system.scale_groups().length_at(static_cast<int>(node));
        turning_[node] = share_ * arm * arm;
    }
    const auto turns_freely = [&](int node) { return !system.supports().has_own_axes(node); };
    for (const Rod& rod : system.model().rods) {
        const auto of_element = static_cast<std::size_t>(rod.order) + 1;
        const std::size_t elements = rod.element_nodes.size() / of_element;
        const auto count = static_cast<double>(elements) * rod.order;
        for (std::size_t i = 0; i + 1 < rod.element_nodes.size(); ++i) {
            if (i % of_element == of_element - 1) continue;  // the next one is of another element
            const int first = rod.element_nodes[i];
            const int second = rod.element_nodes[i + 1];
            if (!turns_freely(first) || !turns_freely(second)) continue;
            const double length = system.scale_groups().length_at(first);
            pairs_.push_back({first, second, bending_of_length * share_ * count * count * length * length});
        }
    }
}

void PseudoDrag::add_forces(double factor,
                            const std::vector<NodeMotion>& from,
                            const std::vector<NodeMotion>& motions,
                            std::vector<Vec6>& nodal) const {
    std::vector<Vec3> turns(motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i) {
        turns[i] = find_turn(from[i], motions[i]);
        nodal[i].head<3>() += factor * share_ * (motions[i].r - from[i].r);
        nodal[i].tail<3>() += factor * turning_[i] * turns[i];
    }
    for (const Pair& pair : pairs_) {
        const auto first = static_cast<std::size_t>(pair.first);
        const auto second = static_cast<std::size_t>(pair.second);
        const Vec3 moment = factor * pair.bending * (turns[second] - turns[first]);
        nodal[second].tail<3>() += moment;
        nodal[first].tail<3>() -= moment;
    }
}

std::vector<double> PseudoDrag::make_matrix(double factor) const {
    std::vector<double> values(static_cast<std::size_t>(system_->pattern().nonzeros()), 0.0);
    const EquationNumbers& equations = system_->equations();
    const SparsePattern& pattern = system_->pattern();
    const auto add = [&](std::int64_t row, std::int64_t column, double value) {
        if (row >= 0 && column >= 0)
            values[static_cast<std::size_t>(pattern.slot(row, column))] += factor * value;
    };
    for (std::size_t node = 0; node < turning_.size(); ++node) {
        const std::array<std::int64_t, 6> numbers = equations.of_node(static_cast<int>(node));
        for (std::size_t i = 0; i < 6; ++i) add(numbers[i], numbers[i], i < 3 ? share_ : turning_[node]);
    }
    for (const Pair& pair : pairs_) {
        const std::array<std::int64_t, 6> first = equations.of_node(pair.first);
        const std::array<std::int64_t, 6> second = equations.of_node(pair.second);
        for (std::size_t i = 3; i < 6; ++i) {
            add(first[i], first[i], pair.bending);
            add(second[i], second[i], pair.bending);
            add(first[i], second[i], -pair.bending);
            add(second[i], first[i], -pair.bending);
        }
    }
    return values;
}

void PseudoStep::add_forces(const State& state, Residual& residual) const {
    if (stiffness_ > 0.0) drag_->add_forces(stiffness_, from_, state.trial, residual.nodal);
}

std::vector<double> PseudoStep::make_tangent() const { return drag_->make_matrix(stiffness_); }

}  // namespace gxrod
