// Bodies that touch rods and each other.

#include "assembly/contact/contact_assembly.hpp"
#include "deck/decks.hpp"
#include "integrators/load_stepping.hpp"
#include "solvers/paired_matrix.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

const Stage crowd_stage{0, 0.0, 1.0, 1.0};

// Two balls that are one body, on a rod, a stick with a knob across it that a ball touches too, a stick whose
// end touches the rod, and a ball at the end of the rod, which it is joined to; the skin is wide.
std::string crowd(const std::string& more, const char* analysis) {
    return R"(
[section.s]
shape = { circle = { radius = 0.05 } }
material = { E = 1e6, nu = 0.3, density = 1000 }
[rod.a]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 3
order = 2
[body.ball]
mass = 1
inertia = [1, 1, 1]
at = [0.4, 0.05, 0.2]
sphere = [{ radius = 0.1, centre = [0.01, -0.02, -0.03] }, { radius = 0.05, centre = [-0.1, -0.05, -0.08] }]
[body.stick]
mass = 1
inertia = [1, 2, 2]
at = [0.55, 0, 0.2]
rotation_vector = [0, 0.1, 1.3]
capsule = { from = [-0.2, 0, -0.09], to = [0.3, 0.02, -0.09], radius = 0.04 }
sphere = { radius = 0.05, centre = [0.05, -0.01, -0.085] }
[body.end_stick]
mass = 1
inertia = [1, 2, 2]
at = [0.8, 0.15, -0.29]
capsule = { from = [0, -0.1, 0.18], to = [0, 0, -0.1], radius = 0.05 }
[body.tip]
mass = 1
inertia = [1, 1, 1]
at = "a.end"
sphere = { radius = 0.08 }
[contact]
skin = 0.6
bend_radius = 0.2
)" + more + "[analysis]\n" +
           analysis;
}

const char* const crowd_statics = "kind = \"static\"\nsteps = 1\n";
const char* const crowd_dynamics = "kind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\n";

struct Crowd {
    explicit Crowd(const std::string& more = "", const char* analysis = crowd_statics)
        : problem(test::read(crowd(more, analysis))) {}

    Problem problem;
    System system{problem.model};
    State state = make_state();

    State make_state() const {
        State start = system.initial_state();
        RandomValues random(3);
        for (std::size_t i = 0; i < start.trial.size(); ++i) {
            const Vec3 displacement = random.vector(2e-3), turn = random.vector(0.02);
            place(start.previous[i], start.previous[i].r + displacement, turn, start.trial[i]);
        }
        contact_assembly_of(system)->search(start);
        return start;
    }
    const ContactPairs& pairs() const { return contact_assembly_of(system)->pairs(); }
};

std::vector<Vec6> crowd_forces(const System& system, const State& state) {
    Residual residual;
    residual.nodal.assign(state.trial.size(), Vec6::Zero());
    contact_assembly_of(system)->pairs().subtract_forces(state, -1.0, residual);
    return residual.nodal;
}

State turn_node(const State& from, std::size_t node, int component, double amount) {
    State moved = from;
    Vec6 delta = Vec6::Zero();
    delta[component] = amount;
    apply_spin(from.previous[node], delta.head<3>(), delta.tail<3>(), moved.trial[node]);
    return moved;
}

// Gives it velocities at the start of a step, in which it is now.
void set_moving(Crowd& scene) {
    RandomValues random(5);
    for (NodeMotion& node : scene.state.previous) {
        node.v = random.vector(1.0);
        node.omega = random.vector(1.0);
    }
    scene.state.trial_time = scene.state.time + 0.1;
}

double crowd_tangent_error(const Crowd& scene) {
    std::vector<NodeLinearization> linearizations(scene.state.trial.size());
    LoadStepping().linearize(scene.state, crowd_stage, linearizations);
    const auto size = static_cast<Eigen::Index>(6 * scene.state.trial.size());
    Eigen::MatrixXd tangent = Eigen::MatrixXd::Zero(size, size), expected = tangent;
    for (const PairBlock& block : scene.pairs().compute_tangents(scene.state, 1.0, linearizations)) {
        for (std::size_t i = 0; i < block.nodes.size(); ++i) {
            for (std::size_t j = 0; j < block.nodes.size(); ++j)
                tangent.block<6, 6>(6 * block.nodes[i], 6 * block.nodes[j]) += block.matrix.block<6, 6>(
                    static_cast<Eigen::Index>(6 * i), static_cast<Eigen::Index>(6 * j));
        }
    }
    for (std::size_t node = 0; node < scene.state.trial.size(); ++node) {
        for (int k = 0; k < 6; ++k) {
            expected.col(static_cast<Eigen::Index>(6 * node) + k) = differentiate(
                [&](double amount) {
                    const std::vector<Vec6> forces =
                        crowd_forces(scene.system, turn_node(scene.state, node, k, amount));
                    Eigen::VectorXd stacked(size);
                    for (std::size_t i = 0; i < forces.size(); ++i)
                        stacked.segment<6>(static_cast<Eigen::Index>(6 * i)) = -forces[i];
                    return stacked;
                },
                1e-5);
        }
    }
    return relative_difference(tangent, expected);
}

}  // namespace

TEST_CASE("Bodies and rods: forces are derivatives of their energy, and in balance",
          "[assembly][touch][bodies]") {
    const Crowd scene;
    const std::vector<Vec6> forces = crowd_forces(scene.system, scene.state);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    double largest = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        sum += forces[i].head<3>();
        moment += scene.state.trial[i].r.cross(forces[i].head<3>()) + forces[i].tail<3>();
        largest = std::max(largest, forces[i].norm());
        for (int k = 0; k < 6; ++k) {
            const double slope = differentiate(
                [&](double amount) {
                    return scene.pairs().compute_energy(turn_node(scene.state, i, k, amount));
                },
                1e-5);
            CHECK(forces[i][k] == Approx(-slope).epsilon(1e-5).margin(1e-6));
        }
    }
    CHECK(largest > 1e-2);
    CHECK(sum.norm() < 1e-12 * largest);
    CHECK(moment.norm() < 1e-12 * largest);
}

TEST_CASE("Bodies and rods: all that is near touches, but where it is joined", "[assembly][touch][bodies]") {
    const Crowd scene("friction = 0.2\n");
    const std::vector<ContactTouch> touches =
        contact_assembly_of(scene.system)->list_touches(scene.state, 0.0);
    const auto touch = [&](int a, int b) {
        return std::ranges::any_of(touches, [&](const ContactTouch& one) {
            return one.rods == std::array{std::min(a, b), std::max(a, b)};
        });
    };
    constexpr int rod = 0, ball = 1, stick = 2, end_stick = 3, tip = 4;
    CHECK(touch(rod, ball));
    CHECK(touch(rod, stick));
    CHECK(touch(rod, end_stick));
    CHECK(touch(ball, stick));
    CHECK_FALSE(touch(rod, tip));
    // What is listed is what acts.
    const std::vector<Vec6> forces = crowd_forces(scene.system, scene.state);
    for (int body = 1; body < 4; ++body) {
        const ObstacleValues values =
            contact_assembly_of(scene.system)
                ->compute_watched({.rod = body, .other = {}, .wants_gap = true}, touches, scene.state, 0.0);
        const int node = scene.problem.model.bodies[static_cast<std::size_t>(body - 1)].node;
        CHECK(values.force.isApprox(forces[static_cast<std::size_t>(node)].head<3>(), 1e-9));
        CHECK(values.least_gap > 0.0);
    }
}

TEST_CASE("Bodies and rods: the tangent is the derivative of the forces", "[assembly][touch][bodies]") {
    for (const char* analysis : {crowd_statics, crowd_dynamics}) {
        CHECK(crowd_tangent_error(Crowd("", analysis)) < 1e-5);
        CHECK(crowd_tangent_error(Crowd("friction = 1e-3\n", analysis)) < 1e-5);
        CHECK(crowd_tangent_error(Crowd("friction = 1e6\n", analysis)) < 1e-5);
    }
    Crowd moving("restitution = 0.6\n", crowd_dynamics);
    set_moving(moving);
    CHECK(crowd_tangent_error(moving) < 1e-5);
}

TEST_CASE("Bodies and rods: a limited increment leaves a gap all the way", "[assembly][touch][bodies]") {
    const Crowd scene;
    RandomValues random(9);
    int shortened = 0;
    for (int sample = 0; sample < 40; ++sample) {
        std::vector<Vec6> increments(scene.state.trial.size());
        for (Vec6& one : increments)
            one << random.vector(sample % 2 == 0 ? 0.05 : 1.0), random.vector(sample % 4 < 2 ? 0.3 : 2.5);
        State state = scene.state;
        const ContactLimits limits = contact_assembly_of(scene.system)->limit(increments, state, 1.0);
        shortened += limits.shorten() ? 1 : 0;
        for (int part = 1; part <= 20; ++part) {
            State moved = scene.state;
            for (std::size_t i = 0; i < increments.size(); ++i) {
                const Vec6 delta = part / 20.0 *
                                   limits.of_parts[static_cast<std::size_t>(
                                       scene.system.scale_groups().part_of_node(static_cast<int>(i)))] *
                                   increments[i];
                apply_spin(scene.state.previous[i], delta.head<3>(), delta.tail<3>(), moved.trial[i]);
            }
            contact_assembly_of(scene.system)->search(moved);
            REQUIRE(contact_assembly_of(scene.system)->count(moved, 1.0).least_gap > 0.0);
        }
    }
    CHECK(shortened > 20);
}
