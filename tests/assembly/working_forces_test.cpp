// Which forces do work: loads, gravity that changes with time, what moving supports exert, damping.

#include "assembly/sample_model.hpp"
#include "assembly/system.hpp"
#include "assembly/system_measures.hpp"
#include "loads/nodal_load.hpp"
#include "solvers/equilibrium.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {}  // namespace

TEST_CASE("loads drive at their nodes, constant gravity does not", "[assembly]") {
    const Model model = make_sample_model();
    const System system(model);
    const State state = make_sample_state(system, 6);
    std::vector<Vec6> expected(model.nodes.size(), Vec6::Zero());
    for (const NodalLoad& load : model.loads) {
        expected[load.node] += compute_load(load, state.trial[load.node], 0.4);
    }
    CHECK(SystemMeasures(system).compute_load_forces(state, 0.4) == expected);
}

TEST_CASE("gravity that changes with time drives by the weight of every node", "[assembly]") {
    Model model = make_sample_model();
    model.loads.clear();
    model.gravity = TimeVector({0.0, TimeFunction([](double t) { return 2.0 * t; }), -3.0});
    const System system(model);
    State state = make_sample_state(system, 6);
    const Vec3 gravity(0.0, 0.8, -3.0);
    const auto nodal = SystemMeasures(system).compute_load_forces(state, 0.4);
    // The weight and its moment about the origin, from the potentials of elements moved as one.
    Model still = model;
    still.gravity = TimeVector(gravity);
    const System same(still);
    const auto potential_of = [&](const State& moved) {
        return SystemMeasures(same).compute_balance(moved, 0.4).gravity_potential;
    };
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
        for (int i = 0; i < 3; ++i) {
            const double pull = differentiate([&](double amount) {
                State moved = state;
                moved.trial[node].r[i] += amount;
                return potential_of(moved);
            });
            CHECK(nodal[node][i] == Approx(-pull).margin(1e-11));
            const double turn = differentiate([&](double amount) {
                State moved = state;
                moved.trial[node].Lambda = exp_quaternion(amount * Vec3::Unit(i)) * moved.trial[node].Lambda;
                return potential_of(moved);
            });
            CHECK(nodal[node][i + 3] == Approx(-turn).margin(1e-11));
        }
    }
    CHECK(SystemMeasures(system).compute_balance(state, 0.4).gravity_potential == 0.0);
}

TEST_CASE("a moving support drives with the force that it exerts, one at rest does not", "[assembly]") {
    Model model = make_sample_model();
    model.loads.clear();
    Support& ball_joint = model.supports[0];
    ball_joint.axes = RandomValues(93).rotation();
    ball_joint.fixed[1] = false;
    ball_joint.moved[1] = true;
    ball_joint.motion[1] = TimeFunction([](double t) { return t; });
    const System system(model);
    const State state = make_sample_state(system, 6);
    Residual residual;
    system.compute_residual(state, 0.4, residual);
    std::vector<Vec6> driving = SystemMeasures(system).compute_load_forces(state, 0.4);
    SystemMeasures(system).add_support_forces(residual, driving);
    // The ball joint leaves moments free.
    CHECK((driving[0].head<3>() - residual.nodal[0].head<3>()).norm() < 1e-14);
    CHECK(driving[0].tail<3>().norm() < 1e-14);
    CHECK(residual.nodal[0].tail<3>().norm() > 0.1);
    for (std::size_t node = 1; node < driving.size(); ++node) CHECK(driving[node].isZero(0.0));
}

namespace {

// A model whose rods are damped, all of whose nodes move.
Model make_damped_model(double kelvin_voigt, double mass_proportional) {
    Model model = make_sample_model();
    model.sections[0].kelvin_voigt = kelvin_voigt;
    model.sections[0].mass_proportional = mass_proportional;
    return model;
}

State make_moving_state(const System& system) {
    State state = make_sample_state(system, 6);
    RandomValues random(17);
    for (NodeMotion& motion : state.trial) {
        motion.v = random.matrix<3, 1>();
        motion.omega = random.matrix<3, 1>();
    }
    return state;
}

// What is the power of the forces by which the residuals of two models differ.
double compute_power_between(const Model& damped, const Model& undamped, double time) {
    const System with(damped);
    const System without(undamped);
    const State state = make_moving_state(with);
    Residual a, b;
    with.compute_residual(state, time, a);
    without.compute_residual(state, time, b);
    double power = 0.0;
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        const Vec6 force = a.nodal[i] - b.nodal[i];
        power += force.head<3>().dot(state.trial[i].v) + force.tail<3>().dot(state.trial[i].omega);
    }
    return power;
}

}  // namespace

TEST_CASE("the power of damping is that of the forces it adds to the residual", "[assembly]") {
    const Model damped = make_damped_model(0.2, 0.3);
    const System system(damped);
    CHECK(system.traits().is_damped);
    const double power = compute_power_between(damped, make_sample_model(), 0.4);
    CHECK(power > 0.1);
    CHECK(SystemMeasures(system).compute_damping_power(make_moving_state(system)) ==
          Approx(power).epsilon(1e-10));
    const Model undamped = make_sample_model();
    const System free_of_damping(undamped);
    CHECK_FALSE(free_of_damping.traits().is_damped);
    CHECK(SystemMeasures(free_of_damping).compute_damping_power(make_moving_state(free_of_damping)) == 0.0);
}

TEST_CASE("the damping action of a short step is its power times the square of the time", "[assembly]") {
    for (const auto& [kelvin_voigt, mass_proportional] : {std::pair(0.2, 0.0), {0.0, 0.3}}) {
        const Model model = make_damped_model(kelvin_voigt, mass_proportional);
        const System system(model);
        State state = make_moving_state(system);
        system.commit(state, 0.0);
        const double power = SystemMeasures(system).compute_damping_power(state);
        constexpr double h = 1e-5;
        for (std::size_t i = 0; i < state.trial.size(); ++i) {
            const NodeMotion& previous = state.previous[i];
            place(previous, previous.r + h * previous.v, h * previous.omega, state.trial[i]);
        }
        CHECK(SystemMeasures(system).compute_damping_action(state) / (h * h) == Approx(power).epsilon(1e-4));
    }
}

TEST_CASE("power is force times velocity and moment times angular velocity", "[assembly]") {
    Model model = make_sample_model();
    Support& ball_joint = model.supports[0];
    ball_joint.fixed[1] = false;
    ball_joint.moved[1] = true;
    ball_joint.motion[1] = TimeFunction([](double t) { return t; });
    const System system(model);
    const State state = make_moving_state(system);
    Residual residual;
    system.compute_residual(state, 0.4, residual);
    double of_loads = 0.0;
    for (const NodalLoad& load : model.loads) {
        const NodeMotion& motion = state.trial[load.node];
        const Vec6 force = compute_load(load, motion, 0.4);
        of_loads += force.head<3>().dot(motion.v) + force.tail<3>().dot(motion.omega);
    }
    const double of_support = residual.nodal[0].head<3>().dot(state.trial[0].v);
    const Power power = compute_power(system, state, 0.4, residual);
    CHECK(power.driving == Approx(of_loads + of_support));
    CHECK(std::abs(of_loads) > 0.1);
    CHECK(std::abs(of_support) > 0.1);
    CHECK(power.damping == 0.0);
}

TEST_CASE("the kinetic energy of motions is that of the books", "[assembly]") {
    const Model model = make_sample_model();
    const System system(model);
    const State state = make_moving_state(system);
    CHECK(SystemMeasures(system).compute_kinetic_energy(state.trial) ==
          Approx(SystemMeasures(system).compute_balance(state, 0.0).kinetic_energy));
}
