// Obstacles around whole models.

#include "assembly/contact/contact_assembly.hpp"
#include "assembly/contact/tractions.hpp"
#include "assembly/sample_model.hpp"
#include "assembly/system_measures.hpp"
#include "integrators/generalized_alpha.hpp"
#include "integrators/load_stepping.hpp"
#include "integrators/newmark_simplified.hpp"
#include "solvers/difference_tangent.hpp"
#include "solvers/trial_rates.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double now = 0.7;
const Stage stage{0, 0.6, 0.1, now};
constexpr double radius = 0.3;
constexpr double skin = 0.8;  // wide, so that much of a rod touches

// A hollow sphere and a plane that all of the state's nodes are clear of, the nearest by a quarter of the
// skin.
void enclose(Model& model, const State& state) {
    Vec3 centre = Vec3::Zero();
    for (const NodeMotion& motion : state.trial) centre += motion.r;
    centre /= static_cast<double>(state.trial.size());
    double furthest = 0.0, lowest = 0.0;
    for (const NodeMotion& motion : state.trial) {
        furthest = std::max(furthest, (motion.r - centre).norm());
        lowest = std::min(lowest, (motion.r - centre).z());
    }
    const double room = 1.25 * radius + 0.25 * skin * radius;
    Obstacle sphere;
    sphere.name = "sphere";
    sphere.shape = SphereShape{{.radius = furthest + room, .is_hollow = true}, centre};
    sphere.friction = 0.4;
    sphere.motion = ObstacleMotion{
        TimeVector(
            std::array<TimeFunction, 3>{TimeFunction([](double t) { return 0.02 * t * t; }), 0.0, 0.0}),
        TimeVector(std::array<TimeFunction, 3>{0.0, TimeFunction([](double t) { return 0.1 * t * t; }), 0.0}),
        centre};
    Obstacle floor;
    floor.name = "floor";
    floor.shape = PlaneShape{.point = centre + Vec3(0.0, 0.0, lowest - room)};
    floor.friction = 0.05;
    model.contact.obstacles = {sphere, floor};
    model.contact.radii.assign(model.rods.size(), radius);
    model.contact.bend_radii.assign(model.rods.size(), 1.0);
    model.contact.skin = skin;
}

State make_state(const Model& model, unsigned seed) {
    const System system(model);
    State state = make_turned_state(system, seed);
    if (contact_assembly_of(system) == nullptr) return state;
    set_tractions(system, state, [&](std::size_t i) {
        return RandomValues(static_cast<unsigned>(i) + seed).vector(0.5);
    });
    return state;
}

// A model that touches what is around its state.
struct Scene {
    Model model;
    State state;
};
Scene make_scene(ElementKind kind, int order, unsigned seed) {
    Scene scene{make_turned_model(kind, order), {}};
    enclose(scene.model, make_state(scene.model, seed));
    scene.state = make_state(scene.model, seed);
    RandomValues random(seed + 10);
    for (std::size_t i = 0; i < scene.state.trial.size(); ++i)
        scene.state.previous[i].r = scene.state.trial[i].r + random.vector(0.02);
    scene.state.time = 0.6;
    return scene;
}

void check_tangent(const System& system, const Integrator& integrator, State state) {
    integrator.start(state);
    update_trial_rates(system, integrator, stage, state);
    std::vector<NodeLinearization> linearizations(state.trial.size());
    integrator.linearize(state, stage, linearizations);
    std::vector<double> values, differences;
    system.compute_tangent(state, now, linearizations, values);
    DifferenceTangent(system).compute(integrator, stage, state, differences);
    CHECK(relative_difference(make_dense(system.pattern(), values),
                              make_dense(system.pattern(), differences)) < 1e-6);
}

Vec3 sum_of(const std::vector<Vec6>& forces) {
    Vec3 sum = Vec3::Zero();
    for (const Vec6& force : forces) sum += force.head<3>();
    return sum;
}

}  // namespace

TEST_CASE("Tangents of models that touch are derivatives of the residual", "[assembly][touch]") {
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        for (int order = 1; order <= 4; ++order) {
            INFO((kind == ElementKind::simo ? "simo" : "objective") << ", order " << order);
            for (const double dissipation : {1.0, 0.3}) {
                Scene scene = make_scene(kind, order, 1);
                scene.model.contact.dissipation = dissipation;
                const System system(scene.model);
                REQUIRE(contact_assembly_of(system) != nullptr);
                REQUIRE(contact_assembly_of(system)->count(scene.state, now).least_gap > 0.0);
                REQUIRE(contact_assembly_of(system)->count(scene.state, now).touching > 1);
                check_tangent(system, LoadStepping(), scene.state);
                check_tangent(system, NewmarkSimplified({0.25, 0.5}), scene.state);
                check_tangent(system, GeneralizedAlpha(0.5), scene.state);
            }
        }
    }
}

TEST_CASE("Tangents of models whose contact is damped are derivatives of the residual", "[assembly][touch]") {
    for (const double dissipation : {1.0, 0.3}) {
        Scene scene = make_scene(ElementKind::objective, 2, 4);
        scene.model.has_time = true;
        scene.model.contact.dissipation = dissipation;
        // Gaps change by some 0.02 in the step of 0.1.
        scene.model.contact.damping = 2.0;
        const System system(scene.model);
        Model undamped_model = scene.model;
        undamped_model.contact.damping = 0.0;
        const System undamped(undamped_model);
        const Vec3 force = sum_of(contact_assembly_of(system)->compute_forces(scene.state, now));
        CHECK((force - sum_of(contact_assembly_of(undamped)->compute_forces(scene.state, now))).norm() >
              0.01 * force.norm());
        check_tangent(system, NewmarkSimplified({0.25, 0.5}), scene.state);
    }
}

TEST_CASE("Without friction forces of contact are derivatives of its energy", "[assembly][touch]") {
    Scene scene = make_scene(ElementKind::objective, 3, 2);
    for (Obstacle& obstacle : scene.model.contact.obstacles) obstacle.friction = 0.0;
    const System system(scene.model);
    scene.state.memory.clear();
    scene.state.previous = scene.state.trial;  // where impulses are along the normal
    const std::vector<Vec6> forces = contact_assembly_of(system)->compute_forces(scene.state, now);
    for (std::size_t node = 0; node < forces.size(); ++node) {
        for (int i = 0; i < 3; ++i) {
            const double slope = differentiate(
                [&](double amount) {
                    State moved = scene.state;
                    moved.trial[node].r[i] += amount;
                    return contact_assembly_of(system)->compute_energy(moved, now);
                },
                1e-4);
            CHECK(forces[node][i] == Approx(-slope).epsilon(1e-6).margin(1e-6));
        }
        CHECK(forces[node].tail<3>().norm() == 0.0);
    }
}

TEST_CASE("What obstacles bear is what rods are pushed by", "[assembly][touch]") {
    const Scene scene = make_scene(ElementKind::objective, 2, 3);
    const System system(scene.model);
    Vec3 on_obstacles = Vec3::Zero();
    for (const ObstacleValues& of_one :
         contact_assembly_of(system)->compute_obstacle_values(scene.state, now))
        on_obstacles += of_one.force;
    const Vec3 on_rods = sum_of(contact_assembly_of(system)->compute_forces(scene.state, now));
    CHECK(on_rods.norm() > 1e-6);
    CHECK((on_rods + on_obstacles).norm() < 1e-12 * on_rods.norm());
    SECTION("and acts from outside") {
        const std::vector<Vec6> none(scene.model.nodes.size(), Vec6::Zero());
        Model alone = scene.model;
        alone.contact = {};
        const Vec3 with = SystemMeasures(system).compute_outer_resultant(scene.state, now, none).force;
        const Vec3 without =
            SystemMeasures(System(alone)).compute_outer_resultant(scene.state, now, none).force;
        CHECK((with - without - on_rods).norm() < 1e-10 * on_rods.norm());
    }
}

TEST_CASE("The number of threads changes no force of contact and no limit", "[assembly][touch]") {
    const Scene scene = make_scene(ElementKind::objective, 3, 4);
    const ThreadTeam team(3);
    const System one(scene.model);
    const System several(scene.model, team);
    CHECK(contact_assembly_of(one)->compute_forces(scene.state, now) ==
          contact_assembly_of(several)->compute_forces(scene.state, now));
    std::vector<Vec6> increments;
    RandomValues random(8);
    for (std::size_t i = 0; i < scene.state.trial.size(); ++i)
        increments.emplace_back() << random.vector(3.0), Vec3::Zero();
    State state = scene.state;
    const ContactLimits a = contact_assembly_of(one)->limit(increments, state, now);
    const ContactLimits b = contact_assembly_of(several)->limit(increments, state, now);
    CHECK(a.shorten());
    CHECK(a.of_parts == b.of_parts);
    CHECK(a.least_gap == b.least_gap);
}

TEST_CASE("A limited increment leaves a gap everywhere", "[assembly][touch]") {
    const Scene scene = make_scene(ElementKind::objective, 2, 5);
    const System system(scene.model);
    RandomValues random(9);
    for (int sample = 0; sample < 20; ++sample) {
        std::vector<Vec6> increments;
        for (std::size_t i = 0; i < scene.state.trial.size(); ++i)
            increments.emplace_back() << random.vector(5.0), Vec3::Zero();
        State state = scene.state;
        const ContactLimits limits = contact_assembly_of(system)->limit(increments, state, now);
        CHECK(limits.shorten());
        for (int part = 1; part <= 20; ++part) {
            State moved = scene.state;
            for (std::size_t i = 0; i < moved.trial.size(); ++i) {
                const auto group =
                    static_cast<std::size_t>(system.scale_groups().part_of_node(static_cast<int>(i)));
                moved.trial[i].r += part / 20.0 * limits.of_parts[group] * increments[i].head<3>();
            }
            CHECK(contact_assembly_of(system)->count(moved, now).least_gap > 0.0);
        }
    }
}

TEST_CASE("Parameters on the law give the law's forces and tangent", "[assembly][touch]") {
    const Scene scene = make_scene(ElementKind::objective, 2, 6);
    const System system(scene.model);
    State state = scene.state;
    contact_assembly_of(system)->start(state, now);
    Residual residual;
    system.compute_residual(state, now, residual);
    const std::vector<Vec6> before = residual.nodal;
    contact_assembly_of(system)->replace_by_tangent_forces(state, now, 1.0, residual);
    double largest = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i)
        largest = std::max(largest, (residual.nodal[i] - before[i]).norm() / (1.0 + before[i].norm()));
    CHECK(largest < 1e-12);
    std::vector<NodeLinearization> linearizations(state.trial.size());
    LoadStepping().linearize(state, stage, linearizations);
    std::vector<double> mixed, primal;
    system.compute_tangent(state, now, linearizations, mixed);
    system.compute_tangent(scene.state, now, linearizations, primal);
    CHECK(relative_difference(make_dense(system.pattern(), mixed), make_dense(system.pattern(), primal)) <
          1e-12);
}

TEST_CASE("Only a commit moves what friction remembers", "[assembly][touch]") {
    const Scene scene = make_scene(ElementKind::objective, 2, 7);
    const System system(scene.model);
    State state = scene.state;
    const std::vector<double> before = state.memory;
    Residual residual;
    system.compute_residual(state, now, residual);
    CHECK(state.memory == before);
    const std::vector<ObstacleValues> trial =
        contact_assembly_of(system)->compute_obstacle_values(state, now);
    system.commit(state, now);
    CHECK(state.memory != before);
    const std::vector<ObstacleValues> kept = contact_assembly_of(system)->compute_obstacle_values(state, now);
    for (std::size_t i = 0; i < kept.size(); ++i)
        CHECK((kept[i].friction - trial[i].friction).norm() < 1e-12);
}
