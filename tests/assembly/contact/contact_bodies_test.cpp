// Bodies that touch obstacles.

#include "assembly/contact/contact_assembly.hpp"
#include "assembly/contact/tractions.hpp"
#include "assembly/sample_model.hpp"
#include "integrators/load_stepping.hpp"
#include "integrators/newmark_simplified.hpp"
#include "rotation/rotation_map.hpp"
#include "solvers/difference_tangent.hpp"
#include "solvers/trial_rates.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double body_now = 0.7;
const Stage body_stage{0, 0.6, 0.1, body_now};

// A capsule and a sphere on one body, a sphere on another, away from their nodes, over a floor, next to a
// ball and in a hollow cylinder that moves. The skin is wide, so that much touches.
Model make_bodies() {
    Model model;
    RandomValues random(3);
    for (int i = 0; i < 2; ++i) {
        model.nodes.push_back({i == 0 ? "stick" : "ball", Vec3(2.0 * i, 0.1, 1.0)});
        Body body{.name = model.nodes.back().name, .node = i, .mass = 1.3};
        body.inertia = Vec3(0.3, 0.4, 0.5).asDiagonal();
        body.centre_of_mass = random.vector(0.1);
        body.attitude = exp_quaternion(random.vector(1.0));
        model.bodies.push_back(body);
    }
    const auto add_floor = [&](const Vec3& point, double friction) {
        Obstacle floor;
        floor.shape = PlaneShape{.point = point};
        floor.friction = friction;
        model.contact.obstacles.push_back(floor);
    };
    add_floor(Vec3(0, 0, -0.05), 0.3);
    Obstacle ball;
    ball.shape = SphereShape{{.radius = 0.9}, Vec3(0.2, 0.2, 3.2)};
    ball.friction = 0.05;
    model.contact.obstacles.push_back(ball);
    Obstacle pipe;
    pipe.shape = CylinderShape{{.radius = 1.4, .is_hollow = true}, Vec3(-9, 0, 1), Vec3(9, 0, 1)};
    pipe.friction = 0.4;
    pipe.motion = ObstacleMotion{
        TimeVector(
            std::array<TimeFunction, 3>{TimeFunction([](double t) { return 0.05 * t * t; }), 0.0, 0.0}),
        TimeVector(std::array<TimeFunction, 3>{TimeFunction([](double t) { return 0.1 * t * t; }), 0.0, 0.0}),
        Vec3(1, 0, 1)};
    model.contact.obstacles.push_back(pipe);
    model.contact.skin = 0.9;
    model.contact.bodies = {
        {.body = 0, .ends = {Vec3(-0.5, 0.1, 0), Vec3(0.6, -0.1, 0.1)}, .radius = 0.6, .force = 3.0},
        {.body = 0, .ends = {Vec3(0.1, 0.3, -0.2), Vec3(0.1, 0.3, -0.2)}, .radius = 0.5, .force = 4.0},
        {.body = 1, .ends = {Vec3(0.1, 0.2, -0.1), Vec3(0.1, 0.2, -0.1)}, .radius = 0.8, .force = 5.0}};
    return model;
}

State make_state(const System& system, unsigned seed) {
    State state = system.initial_state();
    RandomValues random(seed);
    state.time = 0.6;
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        NodeMotion before = state.previous[i];
        before.r += random.vector(0.03);
        before.Lambda = exp_quaternion(random.vector(0.1));
        before.v = random.vector(1.0);
        before.omega = random.vector(1.0);
        state.previous[i] = before;
        place(before, before.r + random.vector(0.05), random.vector(0.2), state.trial[i]);
    }
    // So large that differences hardly turn it.
    set_tractions(system, state, [&](std::size_t) { return random.vector(50.0); });
    return state;
}

// As Newton's method moves nodes, by a part of the increments.
State move(const State& from, const std::vector<Vec6>& increments, double part) {
    State moved = from;
    for (std::size_t i = 0; i < increments.size(); ++i)
        apply_spin(
            from.previous[i], part * increments[i].head<3>(), part * increments[i].tail<3>(), moved.trial[i]);
    return moved;
}

std::vector<Vec6> draw_increments(RandomValues& random, std::size_t count, double size, double turn) {
    std::vector<Vec6> increments(count);
    for (Vec6& one : increments) one << random.vector(size), random.vector(turn);
    return increments;
}

}  // namespace

TEST_CASE("Tangents of bodies that touch are derivatives of the residual", "[assembly][touch][bodies]") {
    for (const bool is_dynamic : {false, true}) {
        for (const double dissipation : {1.0, 0.3, 0.0}) {
            Model model = make_bodies();
            model.contact.dissipation = dissipation;
            if (dissipation == 0.0)
                model.contact.exceptions.push_back(
                    {.between = {std::vector<ContactPart>{{.index = 0}, {.index = 1}},
                                 {{.index = -1}, {.index = -2}, {.index = -3}}},
                     .restitution = 0.7});
            model.has_inertia = model.has_time = is_dynamic;
            const System system(model);
            State state = make_state(system, 1);
            REQUIRE(contact_assembly_of(system)->count(state, body_now).least_gap > 0.0);
            REQUIRE(contact_assembly_of(system)->count(state, body_now).touching > 5);
            const auto check = [&](const Integrator& integrator) {
                State own = state;
                integrator.start(own);
                update_trial_rates(system, integrator, body_stage, own);
                std::vector<NodeLinearization> linearizations(own.trial.size());
                integrator.linearize(own, body_stage, linearizations);
                std::vector<double> values, differences;
                system.compute_tangent(own, body_now, linearizations, values);
                DifferenceTangent(system).compute(integrator, body_stage, own, differences);
                CHECK(relative_difference(make_dense(system.pattern(), values),
                                          make_dense(system.pattern(), differences)) < 1e-6);
            };
            if (is_dynamic) {
                check(NewmarkSimplified({0.25, 0.5}));
            } else {
                check(LoadStepping());
            }
        }
    }
}

TEST_CASE("Without friction forces and moments on bodies are derivatives of contact's energy",
          "[assembly][touch][bodies]") {
    Model model = make_bodies();
    for (Obstacle& obstacle : model.contact.obstacles) obstacle.friction = 0.0;
    model.has_time = model.has_inertia = false;
    const System system(model);
    const State state = make_state(system, 2);
    const std::vector<Vec6> forces = contact_assembly_of(system)->compute_forces(state, body_now);
    for (std::size_t node = 0; node < forces.size(); ++node) {
        CHECK(forces[node].tail<3>().norm() > 1e-3);
        for (int i = 0; i < 6; ++i) {
            const double slope = differentiate(
                [&](double amount) {
                    std::vector<Vec6> increments(forces.size(), Vec6::Zero());
                    increments[node][i] = amount;
                    return contact_assembly_of(system)->compute_energy(move(state, increments, 1.0),
                                                                       body_now);
                },
                1e-4);
            CHECK(forces[node][i] == Approx(-slope).epsilon(1e-6).margin(1e-6));
        }
    }
}

TEST_CASE("What obstacles bear is what bodies are pushed by, and their rows say so",
          "[assembly][touch][bodies]") {
    const Model model = make_bodies();
    const System system(model);
    const State state = make_state(system, 3);
    const ContactAssembly& contact = *contact_assembly_of(system);
    const std::vector<Vec6> on_nodes = contact.compute_forces(state, body_now);
    Vec3 on_obstacles = Vec3::Zero();
    for (const ObstacleValues& of_one : contact.compute_obstacle_values(state, body_now))
        on_obstacles += of_one.force;
    CHECK((on_nodes[0] + on_nodes[1]).head<3>().isApprox(-on_obstacles, 1e-12));
    const std::vector<ContactTouch> touches = contact.list_touches(state, body_now);
    REQUIRE(touches.size() > 5);
    for (int body = 0; body < 2; ++body) {
        Vec6 sum = Vec6::Zero();
        for (const ContactTouch& one : touches) {
            if (one.rods[0] != body) continue;
            sum.head<3>() += one.normal_force + one.friction_force;
        }
        CHECK(sum.head<3>().isApprox(on_nodes[static_cast<std::size_t>(body)].head<3>(), 1e-12));
        const ObstacleValues watched =
            contact.compute_watched({.rod = body, .other = {}, .wants_gap = true}, touches, state, body_now);
        CHECK(watched.force.isApprox(sum.head<3>(), 1e-12));
        CHECK(watched.least_gap > 0.0);
        CHECK(watched.least_gap < 0.9 * 0.8);
    }
}

TEST_CASE("A limited increment leaves bodies a gap all the way", "[assembly][touch][bodies]") {
    Model model = make_bodies();
    model.contact.obstacles.pop_back();  // the one that moves
    const System system(model);
    const State state = make_state(system, 4);
    RandomValues random(9);
    int shortened = 0;
    for (int sample = 0; sample < 60; ++sample) {
        const std::vector<Vec6> increments = draw_increments(random, 2, sample % 2 == 0 ? 0.3 : 2.0, 2.5);
        State trial = state;
        const ContactLimits limits = contact_assembly_of(system)->limit(increments, trial, body_now);
        shortened += limits.shorten() ? 1 : 0;
        for (int part = 1; part <= 50; ++part) {
            std::vector<Vec6> shorter = increments;
            for (std::size_t i = 0; i < 2; ++i)
                shorter[i] *= limits.of_parts[static_cast<std::size_t>(
                    system.scale_groups().part_of_node(static_cast<int>(i)))];
            REQUIRE(
                contact_assembly_of(system)->count(move(state, shorter, part / 50.0), body_now).least_gap >
                0.0);
        }
        for (const double share : limits.of_parts) CHECK(share > 0.0);
    }
    CHECK(shortened > 20);
}

TEST_CASE("The number of threads changes nothing of bodies that touch", "[assembly][touch][bodies]") {
    const Model model = make_bodies();
    const ThreadTeam team(3);
    const System one(model);
    const System several(model, team);
    const State state = make_state(one, 5);
    CHECK(contact_assembly_of(one)->compute_forces(state, body_now) ==
          contact_assembly_of(several)->compute_forces(state, body_now));
    RandomValues random(8);
    const std::vector<Vec6> increments = draw_increments(random, 2, 1.0, 1.0);
    State a = state, b = state;
    CHECK(contact_assembly_of(one)->limit(increments, a, body_now).of_parts ==
          contact_assembly_of(several)->limit(increments, b, body_now).of_parts);
}

TEST_CASE("Rods and bodies share a capsule's law where they are long", "[assembly][touch][bodies]") {
    // A capsule has a weight of its length and a diameter: a sphere that of its diameter.
    Model model = make_bodies();
    model.contact.obstacles.resize(1);
    model.contact.obstacles[0].shape = PlaneShape{};
    model.contact.obstacles[0].friction = 0.0;
    model.contact.skin = 0.1;
    model.has_time = model.has_inertia = false;
    for (Body& body : model.bodies) body.attitude = Quat::Identity();
    constexpr double radius = 0.5, force = 7.0, length = 3.0;
    model.contact.bodies = {
        {.body = 0, .ends = {Vec3(-1, 0, 0), Vec3(2, 0, 0)}, .radius = radius, .force = force},
        {.body = 1, .ends = {Vec3(0, 0, 0), Vec3(0, 0, 0)}, .radius = radius, .force = force}};
    const double half_gap = 0.5 * 0.1 * radius;
    for (Node& node : model.nodes) node.position.z() = radius + half_gap;
    const System system(model);
    const std::vector<Vec6> forces = contact_assembly_of(system)->compute_forces(system.initial_state(), 0.0);
    CHECK(forces[1].isApprox((Vec6() << 0, 0, force, 0, 0, 0).finished(), 1e-12));
    CHECK(forces[0][2] == Approx(force * (1.0 + length / (2.0 * radius))).epsilon(1e-12));
    CHECK(forces[0][4] == Approx(-0.5 * forces[0][2]).epsilon(1e-12));
}
