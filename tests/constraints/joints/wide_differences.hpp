#pragma once

#include <vector>

#include "state/constraint_level.hpp"
#include "state/state.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/node_paths.hpp"
#include "tools/random_values.hpp"

// Derivatives of equations over several nodes, by differences.
namespace gxrod::tools {

// Of function(nodes), a vector, as the unknowns of some nodes move the trial motions.
template <class Function>
Eigen::MatrixXd differentiate_by_unknowns(const State& state,
                                          const std::vector<int>& list,
                                          const NodeLinearization& linearization,
                                          Function&& function,
                                          double width = 1e-3) {
    Eigen::MatrixXd derivative;
    for (std::size_t unknown = 0; unknown < 6 * list.size(); ++unknown) {
        const auto node = static_cast<std::size_t>(list[unknown / 6]);
        const Eigen::VectorXd column = differentiate(
            [&](double amount) {
                std::vector<NodeMotion> nodes = state.trial;
                nodes[node] = follow(state.previous[node],
                                     state.trial[node],
                                     linearization,
                                     Vec6::Unit(static_cast<int>(unknown % 6)),
                                     amount);
                return Eigen::VectorXd(function(nodes));
            },
            width);
        derivative.conservativeResize(column.size(), static_cast<Eigen::Index>(unknown) + 1);
        derivative.col(static_cast<Eigen::Index>(unknown)) = column;
    }
    return derivative;
}

// That values(nodes, level), a vector, is at each level the derivative by time of the level before.
template <class Values>
void check_levels(const State& state, Values&& values) {
    RandomValues random(612);
    std::vector<SmoothMotion> paths;
    for (const NodeMotion& start : state.trial)
        paths.push_back({start, random.vector(), random.vector(2.0), random.vector(2.0), random.vector()});
    const auto at = [&](double t, ConstraintLevel level) {
        std::vector<NodeMotion> nodes;
        for (const SmoothMotion& path : paths) nodes.push_back(path.at(t));
        return Eigen::VectorXd(values(nodes, level));
    };
    constexpr double tolerance = 1e-9, width = 1e-3;
    const Eigen::VectorXd rate =
        differentiate([&](double t) { return at(t, ConstraintLevel::position); }, width);
    CHECK(relative_difference(at(0.0, ConstraintLevel::velocity), rate) < tolerance);
    const Eigen::VectorXd acceleration =
        differentiate([&](double t) { return at(t, ConstraintLevel::velocity); }, width);
    CHECK(relative_difference(at(0.0, ConstraintLevel::acceleration), acceleration) < tolerance);
}

}  // namespace gxrod::tools
