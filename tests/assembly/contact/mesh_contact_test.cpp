// Meshes around whole models.

#include <cmath>
#include <cstring>
#include <utility>

#include "assembly/contact/contact_assembly.hpp"
#include "assembly/contact/tractions.hpp"
#include "assembly/sample_model.hpp"
#include "contact/meshes.hpp"
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

constexpr double mesh_now = 0.7;
const Stage mesh_stage{0, 0.6, 0.1, mesh_now};
constexpr double ball = 0.3;
constexpr double wide_skin = 0.5;  // so that much of a rod touches

struct MeshScene {
    Model model;
    State state;
};

State make_state_on(const Model& model, unsigned seed) {
    const System system(model);
    State state = make_turned_state(system, seed);
    if (contact_assembly_of(system) == nullptr) return state;
    set_tractions(system, state, [&](std::size_t i) {
        return RandomValues(static_cast<unsigned>(i) + seed).vector(0.5);
    });
    return state;
}

double find_lowest(const State& state) {
    double lowest = 1e9;
    for (const NodeMotion& motion : state.trial) lowest = std::min(lowest, motion.r.z());
    return lowest;
}

// A model above a ground of triangles, whose heights vary, so near that a gap of a quarter of the skin is
// left.
MeshScene make_mesh_scene(int order, unsigned seed, double bumps, double feature_angle, bool is_moved) {
    MeshScene scene{make_turned_model(ElementKind::objective, order), {}};
    scene.model.contact.radii.assign(scene.model.rods.size(), ball);
    scene.model.contact.bend_radii.assign(scene.model.rods.size(), 1.0);
    scene.model.contact.skin = wide_skin;
    const State bare = make_state_on(scene.model, seed);
    TriangleMesh ground = make_floor(6.0, 31);
    RandomValues random(seed + 20);
    for (Vec3& position : ground.positions) position.z() = bumps * random.number(-1.0, 1.0);
    ground.feature_angle = feature_angle;
    for (Vec3& position : ground.positions) position.z() += find_lowest(bare) - 5.0 * ball;
    Obstacle obstacle = make_obstacle(ground);
    obstacle.friction = 0.3;
    scene.model.contact.obstacles = {obstacle};
    const double gap =
        contact_assembly_of(System(scene.model))->count(make_state_on(scene.model, seed), mesh_now).least_gap;
    for (Vec3& position : ground.positions) position.z() += gap - 0.25 * wide_skin * ball;
    obstacle = make_obstacle(ground);
    obstacle.friction = 0.3;
    if (is_moved)
        obstacle.motion = ObstacleMotion{TimeVector(std::array<TimeFunction, 3>{
                                             TimeFunction([](double t) { return 0.01 * t; }), 0.0, 0.0}),
                                         TimeVector(std::array<TimeFunction, 3>{
                                             0.0, 0.0, TimeFunction([](double t) { return 0.02 * t; })}),
                                         Vec3::Zero()};
    scene.model.contact.obstacles = {obstacle};
    scene.state = make_state_on(scene.model, seed);
    RandomValues moves(seed + 10);
    for (std::size_t i = 0; i < scene.state.trial.size(); ++i)
        scene.state.previous[i].r = scene.state.trial[i].r + moves.vector(0.02);
    scene.state.time = 0.6;
    return scene;
}

void check_mesh_tangent(const System& system, const Integrator& integrator, State state) {
    integrator.start(state);
    update_trial_rates(system, integrator, mesh_stage, state);
    std::vector<NodeLinearization> linearizations(state.trial.size());
    integrator.linearize(state, mesh_stage, linearizations);
    std::vector<double> values, differences;
    system.compute_tangent(state, mesh_now, linearizations, values);
    DifferenceTangent(system).compute(integrator, mesh_stage, state, differences);
    CHECK(relative_difference(make_dense(system.pattern(), values),
                              make_dense(system.pattern(), differences)) < 1e-6);
}

}  // namespace

TEST_CASE("Tangents of models on a mesh are derivatives of the residual", "[assembly][touch]") {
    for (int order = 1; order <= 3; ++order) {
        for (const double angle : {0.1, 3.0}) {  // each triangle on its own; all of them together
            INFO("order " << order << ", feature angle " << angle);
            const MeshScene scene = make_mesh_scene(order, 1, 0.1, angle, false);
            const System system(scene.model);
            REQUIRE(contact_assembly_of(system)->count(scene.state, mesh_now).least_gap > 0.0);
            REQUIRE(contact_assembly_of(system)->count(scene.state, mesh_now).touching > 1);
            check_mesh_tangent(system, LoadStepping(), scene.state);
            check_mesh_tangent(system, NewmarkSimplified({0.25, 0.5}), scene.state);
        }
    }
}

TEST_CASE("Without friction forces of a mesh are derivatives of its energy", "[assembly][touch]") {
    MeshScene scene = make_mesh_scene(3, 2, 0.1, 0.1, false);
    for (Obstacle& obstacle : scene.model.contact.obstacles) obstacle.friction = 0.0;
    const System system(scene.model);
    scene.state.memory.clear();
    scene.state.previous = scene.state.trial;  // of no motion, whose impulses are forces
    const std::vector<Vec6> forces = contact_assembly_of(system)->compute_forces(scene.state, mesh_now);
    Vec3 sum = Vec3::Zero();
    double largest = 0.0;
    for (const Vec6& force : forces) {
        sum += force.head<3>();
        largest = std::max(largest, force.norm());
    }
    REQUIRE(largest > 0.0);
    for (std::size_t node = 0; node < forces.size(); ++node) {
        for (int i = 0; i < 3; ++i) {
            const double slope = differentiate(
                [&](double amount) {
                    State moved = scene.state;
                    moved.trial[node].r[i] += amount;
                    return contact_assembly_of(system)->compute_energy(moved, mesh_now);
                },
                1e-4);
            CHECK(forces[node][i] == Approx(-slope).epsilon(1e-6).margin(1e-6 * largest));
        }
    }
    const std::vector<ObstacleValues> values =
        contact_assembly_of(system)->compute_obstacle_values(scene.state, mesh_now);
    REQUIRE(values.size() == 1);  // however many surfaces the mesh has
    CHECK((values[0].force + sum).norm() < 1e-12 * largest);
}

TEST_CASE("A flat mesh pushes and rubs as a plane does", "[assembly][touch]") {
    for (const bool is_moved : {false, true}) {
        MeshScene scene = make_mesh_scene(2, 3, 0.0, 0.35, is_moved);
        const System on_mesh(scene.model);
        const std::vector<Vec6> forces = contact_assembly_of(on_mesh)->compute_forces(scene.state, mesh_now);
        Model model = scene.model;
        Obstacle plane = model.contact.obstacles[0];
        plane.shape = PlaneShape{.point = plane.mesh()->positions[0]};
        Obstacle far = scene.model.contact.obstacles[0];  // so that the places are the same
        auto lowered = std::make_shared<TriangleMesh>(*far.mesh());
        for (Vec3& position : lowered->positions) position.z() -= 10.0;
        far.shape = MeshShape{lowered};
        far.motion.reset();
        model.contact.obstacles = {plane, far};
        State state = scene.state;
        state.memory.resize(2 * state.memory.size());
        const System on_plane(model);
        const std::vector<Vec6> expected = contact_assembly_of(on_plane)->compute_forces(state, mesh_now);
        double largest = 0.0, difference = 0.0;
        for (std::size_t i = 0; i < forces.size(); ++i) {
            largest = std::max(largest, expected[i].norm());
            difference = std::max(difference, (forces[i] - expected[i]).norm());
        }
        REQUIRE(largest > 0.0);
        CHECK(difference < 1e-9 * largest);
    }
}

TEST_CASE("A limited increment leaves a gap to a mesh that moves and turns", "[assembly][touch]") {
    for (const bool is_moved : {false, true}) {
        MeshScene scene = make_mesh_scene(2, 5, 0.2, 0.35, is_moved);
        if (is_moved)
            scene.model.contact.obstacles[0].motion->rotation = TimeVector(std::array<TimeFunction, 3>{
                TimeFunction([](double t) { return 3.0 * (t - 0.6); }), 0.0, 0.0});
        scene.state.contact.progress = 0.0;
        const System system(scene.model);
        REQUIRE(contact_assembly_of(system)->count(scene.state, mesh_now).least_gap > 0.0);
        RandomValues random(9);
        int shortened = 0;
        for (int sample = 0; sample < 20; ++sample) {
            std::vector<Vec6> increments;
            for (std::size_t i = 0; i < scene.state.trial.size(); ++i)
                increments.emplace_back() << random.vector(2.0), Vec3::Zero();
            State state = scene.state;
            const ContactLimits limits = contact_assembly_of(system)->limit(increments, state, mesh_now);
            shortened += limits.shorten();
            for (int part = 1; part <= 20; ++part) {
                State moved = scene.state;
                moved.contact.progress = part / 20.0 * limits.least;
                for (std::size_t i = 0; i < moved.trial.size(); ++i)
                    moved.trial[i].r += moved.contact.progress * increments[i].head<3>();
                CHECK(contact_assembly_of(system)->count(moved, mesh_now).least_gap > 0.0);
            }
        }
        CHECK(shortened > 10);
    }
}

TEST_CASE("What starts in a mesh, or through it, is named", "[assembly][touch]") {
    MeshScene scene = make_mesh_scene(2, 6, 0.0, 0.35, false);
    const System system(scene.model);
    CHECK(contact_assembly_of(system)->describe_overlap(scene.state, mesh_now).empty());
    for (NodeMotion& motion : scene.state.trial) motion.r.z() -= 0.3 * wide_skin * ball;
    CHECK_THAT(contact_assembly_of(system)->describe_overlap(scene.state, mesh_now),
               Catch::Contains("deep in triangle ") && Catch::Contains("of obstacle \"mesh\""));
    for (NodeMotion& motion : scene.state.trial) motion.r.z() -= 1.2 * ball;
    CHECK_THAT(contact_assembly_of(system)->describe_overlap(scene.state, mesh_now),
               Catch::Contains("crosses triangle ") && Catch::Contains("of obstacle \"mesh\""));
}

TEST_CASE("What contact remembers of meshes changes no bit of forces, tangents and limits",
          "[assembly][touch]") {
    for (const bool is_moved : {false, true}) {
        for (const double dissipation : {1.0, 0.3}) {
            MeshScene scene = make_mesh_scene(2, 6, 0.1, 0.1, is_moved);
            scene.model.contact.dissipation = dissipation;
            const System warm(scene.model);
            RandomValues random(12);
            int touching = 0;
            State state = scene.state;
            for (int sample = 0; sample < 30; ++sample) {
                INFO("sample " << sample << ", moved " << is_moved << ", dissipation " << dissipation);
                const System cold(scene.model);
                std::vector<Vec6> increments;
                const double size = std::pow(10.0, random.number(-5.0, 0.0));
                for (std::size_t i = 0; i < state.trial.size(); ++i)
                    increments.emplace_back() << random.vector(size), Vec3::Zero();
                const auto found = [&](const System& system) {
                    const ContactAssembly& contact = *contact_assembly_of(system);
                    State own = state;
                    contact.start(own, mesh_now);
                    std::vector<double> numbers;
                    for (const Vec6& force : contact.compute_forces(own, mesh_now))
                        numbers.insert(numbers.end(), force.begin(), force.end());
                    const ContactLimits limits = contact.limit(increments, own, mesh_now);
                    numbers.push_back(limits.least);
                    numbers.push_back(limits.least_gap);
                    contact.advance(increments, mesh_now, own);
                    for (std::size_t i = 0; i < own.trial.size(); ++i)
                        own.trial[i].r += limits.least * increments[i].head<3>();
                    Residual residual;
                    residual.nodal.assign(own.trial.size(), Vec6::Zero());
                    contact.replace_by_tangent_forces(own, mesh_now, 1.0, residual);
                    for (const Vec6& force : residual.nodal)
                        numbers.insert(numbers.end(), force.begin(), force.end());
                    const std::vector<NodeLinearization> linearizations(own.trial.size());
                    std::vector<double> values;
                    system.compute_tangent(own, mesh_now, linearizations, values);
                    numbers.insert(numbers.end(), values.begin(), values.end());
                    numbers.push_back(contact.count(own, mesh_now).least_gap);
                    touching += static_cast<int>(contact.count(own, mesh_now).touching);
                    numbers.push_back(contact.compute_energy(own, mesh_now));
                    numbers.push_back(contact.compute_work(own, mesh_now, 0.0).loss);
                    numbers.push_back(contact.compute_obstacle_values(own, mesh_now)[0].least_gap);
                    for (const double gap : contact.compute_gaps(own, mesh_now)) numbers.push_back(gap);
                    contact.commit(own, mesh_now);
                    numbers.insert(numbers.end(), own.memory.begin(), own.memory.end());
                    return std::pair(numbers, own.trial);
                };
                const auto [expected, moved] = found(cold);
                const std::vector<double> numbers = found(warm).first;
                REQUIRE(numbers.size() == expected.size());
                REQUIRE(std::memcmp(numbers.data(), expected.data(), numbers.size() * sizeof(double)) == 0);
                state.trial = moved;
            }
            CHECK(touching > 30);
        }
    }
}
