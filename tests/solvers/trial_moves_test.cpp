#include "solvers/trial_moves.hpp"

#include "assembly/sample_model.hpp"
#include "solvers/newton_steps.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("What a support's motion does to the residual is what a small motion does", "[solvers]") {
    Model model = make_turned_model(ElementKind::objective, 2);
    Support support{.node = 1, .moved = {true, true, true, true, true, true}};
    support.motion[0] = TimeFunction([](double t) { return 0.1 * t; });
    support.motion[1] = TimeFunction([](double t) { return -0.2 * t * t; });
    support.motion[3] = TimeFunction([](double t) { return 0.9 * t; });
    support.motion[5] = TimeFunction([](double t) { return -0.5 * t * t; });
    model.supports.push_back(support);
    const System system(model);
    State state = make_turned_state(system, 5);
    constexpr double now = 1.1, next = 1.101;
    system.supports().place(now, state);
    REQUIRE(state.trial[1].theta.norm() > 0.5);  // since the last accepted step
    const std::vector<double> values(static_cast<std::size_t>(system.pattern().nonzeros()), 0.0);
    Residual here, there;
    system.compute_residual(state, 0.0, here);
    constexpr double part = 1e-6;
    const Eigen::VectorXd found = compute_support_motion_force(system, next, 0.0, part, here, values, state);
    State moved = state;
    system.supports().place(next, moved);
    system.compute_residual(moved, 0.0, there);
    const Eigen::VectorXd expected =
        gather_residual(system, there, values) - gather_residual(system, here, values);
    CHECK(relative_difference(found, expected) < 1e-2);
    std::vector<Vec6> deltas(state.trial.size(), Vec6::Zero());
    add_support_motion(system, next, state, deltas);
    CHECK(exp_quaternion(deltas[1].tail<3>())
              .angularDistance(moved.trial[1].Lambda * state.trial[1].Lambda.conjugate()) < 1e-12);
    CHECK(relative_difference(deltas[1].head<3>(), Vec3(moved.trial[1].r - state.trial[1].r)) < 1e-12);
}
