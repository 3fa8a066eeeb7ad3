#include "solvers/divergence.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "tools/catch.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double length = 10.0;
constexpr double stiffness = 500.0;
constexpr double euler = std::numbers::pi * std::numbers::pi * stiffness / (4.0 * length * length);

// Clamped at its start, pushed at its end along the line, by a dead load or one that follows.
Model make_column(double push, Frame frame) {
    Model model =
        make_rod_model(along_x, length, {4, 2}, make_section({1e4, 1e4, 1e4, 2000.0, 4000.0, stiffness}));
    clamp(model, 0);
    NodalLoad load;
    load.key = "load[0]";
    load.node = last_node(model);
    load.frame = frame;
    load.force[0] = ramp(-push);
    model.loads.push_back(load);
    return model;
}

// The rates of drag x′ = −K x, by a dense solver.
Eigen::VectorXcd find_rates(const System& system, const PseudoDrag& drag, State& state) {
    std::vector<double> values;
    const NodeLinearization placement{.placement = 1.0};
    system.compute_tangent(state, 1.0, std::vector<NodeLinearization>(state.trial.size(), placement), values);
    const auto make_dense = [&](const std::vector<double>& sparse) {
        const auto size = system.equations().count();
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
        system.pattern().visit_entries(
            [&](auto row, auto column, auto slot) { dense(row, column) = sparse[slot]; });
        return dense;
    };
    const Eigen::MatrixXd matrix = make_dense(drag.make_matrix()).inverse() * make_dense(values);
    return -Eigen::EigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
}

double largest_real(const Eigen::VectorXcd& values) { return values.real().maxCoeff(); }

// The column, straight, as short as its load presses it.
State press(const System& system, double push) {
    State state = system.initial_state();
    for (std::vector<NodeMotion>* motions : {&state.previous, &state.trial}) {
        for (NodeMotion& motion : *motions) motion.r.x() *= 1.0 - push / 1e4;
    }
    return state;
}

std::optional<Divergence> find(double push, Frame frame) {
    const Model model = make_column(push, frame);
    const System system(model);
    const PseudoDrag drag(system);
    State state = press(system, push);
    const double rate = largest_real(find_rates(system, drag, state));
    const std::optional<Divergence> found = find_divergence(system, 1.0, drag, 1e-6, state);
    if (found) {
        CHECK(found->rate == Approx(rate).epsilon(1e-5));
        CHECK(found->stiffness >= found->rate * (1.0 - 1e-5));
    } else {
        CHECK(rate < 1e-6);
    }
    return found;
}

}  // namespace

TEST_CASE("A column diverges in pseudo-time above its Euler load, at the rate of a dense solver",
          "[solvers]") {
    CHECK_FALSE(find(0.99 * euler, Frame::spatial));
    CHECK(find(1.05 * euler, Frame::spatial));
    // Two shapes: the determinant is positive again.
    CHECK(find(9.5 * euler, Frame::spatial));
}

TEST_CASE("A load that follows a column makes nothing diverge, though the tangent is not symmetric",
          "[solvers]") {
    // It flutters at 8.1 times the Euler load (Beck); the symmetric part of the tangent is indefinite from
    // four times on: the smallest P for which EI ∫ w'' w'' − P (∫ w' w' − w(L) w'(L)) is.
    CHECK_FALSE(find(6.0 * euler, Frame::follower));
    for (const auto& [factor, is_indefinite] : {std::pair{3.9, false}, {4.1, true}}) {
        const Model model = make_column(factor * euler, Frame::follower);
        const System system(model);
        State state = press(system, factor * euler);
        CHECK(is_softer_than(0.0, system, 1.0, PseudoDrag(system), state) == is_indefinite);
    }
}

TEST_CASE("Stiffness is compared with the drag", "[solvers]") {
    const Model model = make_column(0.0, Frame::spatial);
    const System system(model);
    const PseudoDrag drag(system);
    State state = system.initial_state();
    const double softest = -largest_real(find_rates(system, drag, state));
    CHECK_FALSE(is_softer_than(0.999 * softest, system, 1.0, drag, state));
    CHECK(is_softer_than(1.001 * softest, system, 1.0, drag, state));
}
