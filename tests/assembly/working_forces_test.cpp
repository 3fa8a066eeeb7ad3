// Which forces do work: loads, gravity that changes with time, what moving supports exert, damping.
#include <catch2/catch.hpp>

#include "assembly/sample_model.hpp"
#include "assembly/system.hpp"
#include "loads/nodal_load.hpp"
#include "solvers/equilibrium.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

WorkingForces compute_forces(const System& system, const State& state, double time) {
    Residual residual;
    system.compute_residual(state, time, residual);
    return system.compute_working_forces(state, time, residual);
}

}  // namespace

TEST_CASE("loads drive at their nodes, constant gravity does not", "[assembly]") {
    const Model model = make_sample_model();
    const System system(model);
    const State state = make_sample_state(system, 6);
    std::vector<Vec6> expected(model.nodes.size(), Vec6::Zero());
    for (const NodalLoad& load : model.loads) {
        expected[load.node] += compute_load(load, state.trial[load.node], 0.4);
    }
    const WorkingForces forces = compute_forces(system, state, 0.4);
    CHECK(forces.driving == expected);
    CHECK(forces.damping.empty());
}

TEST_CASE("gravity that changes with time drives by the weight of every node", "[assembly]") {
    Model model = make_sample_model();
    model.loads.clear();
    model.gravity = TimeVector({0.0, TimeFunction([](double t) { return 2.0 * t; }), -3.0});
    const System system(model);
    State state = make_sample_state(system, 6);
    const Vec3 gravity(0.0, 0.8, -3.0);
    const auto nodal = compute_forces(system, state, 0.4).driving;
    // The weight and its moment about the origin, from the potentials of elements moved as one.
    Model still = model;
    still.gravity = TimeVector(gravity);
    const System same(still);
    const auto potential_of = [&](const State& moved) {
        return same.compute_balance(moved, 0.4).gravity_potential;
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
    CHECK(system.compute_balance(state, 0.4).gravity_potential == 0.0);
}

TEST_CASE("a moving support drives with the force that it exerts, one that stands still does not",
          "[assembly]") {
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
    const auto driving = system.compute_working_forces(state, 0.4, residual).driving;
    // The ball joint leaves moments free.
    CHECK((driving[0].head<3>() - residual.nodal[0].head<3>()).norm() < 1e-14);
    CHECK(driving[0].tail<3>().norm() < 1e-14);
    CHECK(residual.nodal[0].tail<3>().norm() > 0.1);
    for (std::size_t node = 1; node < driving.size(); ++node) CHECK(driving[node].isZero(0.0));
}

TEST_CASE("damping forces are gathered from elements with damping", "[assembly]") {
    Model model = make_sample_model();
    model.sections[0].kelvin_voigt = 0.2;
    model.sections[0].mass_proportional = 0.3;
    const System system(model);
    CHECK(system.is_damped());
    State state = make_sample_state(system, 6);
    for (NodeMotion& motion : state.trial) motion.v = motion.omega = Vec3(1.0, -2.0, 0.5);
    Residual damped, undamped;
    system.compute_residual(state, 0.4, damped);
    const auto forces = system.compute_working_forces(state, 0.4, damped).damping;
    model.sections[0].kelvin_voigt = model.sections[0].mass_proportional = 0.0;
    const System free_of_damping(model);
    CHECK_FALSE(free_of_damping.is_damped());
    free_of_damping.compute_residual(state, 0.4, undamped);
    for (std::size_t node = 0; node < forces.size(); ++node) {
        CHECK((damped.nodal[node] - undamped.nodal[node] - forces[node]).norm() < 1e-12);
    }
    CHECK(forces[1].norm() > 0.1);
    CHECK(forces[lone_node].isZero(0.0));  // a rigid body
}

TEST_CASE("power is force times velocity and moment times angular velocity", "[assembly]") {
    std::vector<NodeMotion> motions(2);
    motions[0].v = Vec3(5.0, 7.0, 0.0);
    motions[0].omega = Vec3(1.0, 0.0, -2.0);
    motions[1].v = Vec3(0.0, 1.0, 0.0);
    WorkingForces forces;
    forces.driving.resize(2, Vec6::Zero());
    forces.driving[0] << 0.0, 6.0, 0.0, 0.0, 0.0, 3.0;
    forces.driving[1] << 0.0, 11.0, 0.0, 0.0, 0.0, 0.0;
    CHECK(compute_power(forces, motions).driving == 6.0 * 7.0 - 3.0 * 2.0 + 11.0);
    CHECK(compute_power(forces, motions).damping == 0.0);
    forces.damping.resize(2, Vec6::Ones());
    CHECK(compute_power(forces, motions).damping == 12.0 - 1.0 + 1.0);
}
