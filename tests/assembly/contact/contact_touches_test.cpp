// What touches where, against the forces on nodes and obstacles.

#include <algorithm>

#include "assembly/contact/contact_assembly.hpp"
#include "assembly/contact/tractions.hpp"
#include "assembly/system.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Two rods on a floor and beside a drum, which a third one crosses; the skin is wide.
const char* heap = R"(
[section.s]
shape = { circle = { radius = 0.05 } }
material = { E = 1e6, nu = 0.3, density = 1000 }
[rod.a]
section = "s"
line = { from = [0, 0, 0.07], to = [1, 0, 0.06] }
elements = 3
order = 2
[rod.b]
section = "s"
line = { from = [0, 0.115, 0.07], to = [1, 0.112, 0.065] }
elements = 4
order = 1
[rod.c]
section = "s"
line = { from = [0.4, -0.5, 0.18], to = [0.6, 0.5, 0.17] }
elements = 2
order = 3
[[support]]
at = "a.start"
fix = "all"
[obstacle.floor]
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
friction = 0.3
[obstacle.drum]
cylinder = { from = [0.8, -0.36, 0], to = [0.8, -0.36, 1], radius = 0.3 }
[contact]
skin = 0.6
bend_radius = 0.2
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.1
)";

struct Scene {
    explicit Scene(int threads = 1) : team(threads) {
        RandomValues random(5);
        for (NodeMotion& motion : state.trial) motion.r += random.vector(2e-3);
        set_tractions(system, state, [&](std::size_t) { return random.vector(2.0); });
        contact().search(state);
    }
    const ContactAssembly& contact() const { return *contact_assembly_of(system); }
    std::vector<ContactTouch> touches() const { return contact().list_touches(state, 0.0); }

    Problem problem = test::read(heap);
    ThreadTeam team;
    System system{problem.model, team};
    State state = system.initial_state();
};

Vec3 force_of(const ContactTouch& touch) { return touch.normal_force + touch.friction_force; }

}  // namespace

TEST_CASE("Touches: their forces are those on the nodes of each rod", "[assembly][touch]") {
    const Scene scene;
    const std::vector<Vec6> nodal = scene.contact().compute_forces(scene.state, 0.0);
    const std::vector<ContactTouch> touches = scene.touches();
    for (int rod = 0; rod < 3; ++rod) {
        Vec3 expected = Vec3::Zero(), sum = Vec3::Zero();
        for (const int node : scene.problem.model.rods[static_cast<std::size_t>(rod)].nodes)
            expected += nodal[static_cast<std::size_t>(node)].head<3>();
        for (const ContactTouch& touch : touches) {
            if (touch.rods[0] == rod) sum += force_of(touch);
            if (touch.rods[1] == rod) sum -= force_of(touch);
        }
        CHECK(expected.norm() > 1.0);
        CHECK((sum - expected).norm() < 1e-12 * expected.norm());
        const ObstacleValues watched =
            scene.contact().compute_watched({.rod = rod}, touches, scene.state, 0.0);
        CHECK((watched.force - expected).norm() < 1e-12 * expected.norm());
    }
}

TEST_CASE("Touches: those at an obstacle are the force on it", "[assembly][touch]") {
    const Scene scene;
    const std::vector<ObstacleValues> values = scene.contact().compute_obstacle_values(scene.state, 0.0);
    const std::vector<ContactTouch> touches = scene.touches();
    for (int obstacle = 0; obstacle < 2; ++obstacle) {
        const ObstacleValues& expected = values[static_cast<std::size_t>(obstacle)];
        Vec3 normal = Vec3::Zero(), friction = Vec3::Zero(), watched = Vec3::Zero();
        double least = 1.0;
        for (const ContactTouch& touch : touches) {
            if (touch.rods[1] != -1 - obstacle) continue;
            normal += touch.normal_force;
            friction += touch.friction_force;
            least = std::min(least, touch.gap);
        }
        double watched_gap = 1.0;
        for (int rod = 0; rod < 3; ++rod) {
            const ObstacleValues of_rod = scene.contact().compute_watched(
                {.rod = rod, .other = -1 - obstacle, .wants_gap = true}, touches, scene.state, 0.0);
            watched += of_rod.force;
            watched_gap = std::min(watched_gap, of_rod.least_gap);
        }
        CHECK(expected.force.norm() > 0.1);
        CHECK((normal + friction + expected.force).norm() < 1e-12 * expected.force.norm());
        CHECK((friction + expected.friction).norm() < 1e-12 * expected.force.norm());
        CHECK((watched + expected.force).norm() < 1e-12 * expected.force.norm());
        CHECK(least == expected.least_gap);
        CHECK(watched_gap == expected.least_gap);
    }
}

TEST_CASE("Touches: sorted, each place once, and the same for any number of threads", "[assembly][touch]") {
    const std::vector<ContactTouch> touches = Scene(1).touches();
    const std::vector<ContactTouch> others = Scene(3).touches();
    REQUIRE(touches.size() == others.size());
    CHECK(std::ranges::any_of(touches, [](const ContactTouch& one) { return one.rods[1] >= 0; }));
    for (std::size_t i = 0; i < touches.size(); ++i) {
        const ContactTouch& one = touches[i];
        CHECK(one.rods == others[i].rods);
        CHECK(one.places == others[i].places);
        CHECK(one.point == others[i].point);
        CHECK(one.normal_force == others[i].normal_force);
        CHECK(one.friction_force == others[i].friction_force);
        if (i == 0) continue;
        const auto key = [](const ContactTouch& touch) { return std::pair(touch.rods, touch.places); };
        CHECK(key(touches[i - 1]) < key(one));
    }
}

TEST_CASE("Touches: friction holds within the cone, and slides on it", "[assembly][touch]") {
    Scene scene;
    set_tractions(scene.system, scene.state, [](std::size_t) { return Vec3(1e6 * Vec3::UnitX()); });
    for (const ContactTouch& one : scene.touches()) {
        if (one.rods[1] != -1) continue;
        CHECK(one.slides);
        CHECK(one.friction_force.norm() == Approx(0.3 * one.normal_force.norm()));
    }
    std::ranges::fill(scene.state.memory, 0.0);
    scene.state.previous = scene.state.trial;
    for (const ContactTouch& one : scene.touches()) {
        if (one.rods[1] == -1) CHECK_FALSE(one.slides);
        // Nothing holds where there is no friction.
        if (one.rods[1] == -2) CHECK(one.slides);
    }
}

TEST_CASE("Touches: two rods at a right angle push where they cross", "[assembly][touch]") {
    const Problem problem =
        test::read(test::replaced(heap, "to = [0.6, 0.5, 0.17]", "to = [0.4, 0.5, 0.18]"));
    const System system(problem.model);
    State state = system.initial_state();
    contact_assembly_of(system)->search(state);
    // Two elements of c meet where it crosses a.
    Vec3 force = Vec3::Zero();
    double weight = 0.0, place = 0.0;
    for (const ContactTouch& one : contact_assembly_of(system)->list_touches(state, 0.0)) {
        if (one.rods != std::array{0, 2}) continue;
        CHECK(one.places[0] == Approx(0.4).margin(2e-3));
        CHECK(one.point.x() == Approx(0.4).margin(2e-3));
        CHECK(one.point.z() == Approx(0.5 * (0.066 + 0.18)).margin(1e-3));
        CHECK(one.gap == Approx(0.18 - 0.066 - 0.1).margin(1e-3));
        force += one.normal_force;
        place += one.normal_force.norm() * one.places[1];
        weight += one.normal_force.norm();
    }
    CHECK(place / weight == Approx(0.5).margin(2e-3));
    CHECK(force.z() == Approx(-force.norm()).epsilon(1e-3));
}

TEST_CASE("Touches: the least gap of rods that are far from each other", "[assembly][touch]") {
    const Problem problem = test::read(
        test::replaced(heap, "[0.4, -0.5, 0.18], to = [0.6, 0.5, 0.17]", "[0.4, 0, 3], to = [0.6, 0, 3]"));
    const System system(problem.model);
    State state = system.initial_state();
    contact_assembly_of(system)->search(state);
    const auto gap = [&](int rod, std::optional<int> other) {
        return contact_assembly_of(system)
            ->compute_watched({.rod = rod, .other = other, .wants_gap = true}, {}, state, 0.0)
            .least_gap;
    };
    // Rod a is at z = 0.064 under the end of c.
    CHECK(gap(0, 2) == Approx(3.0 - 0.066 - 0.1).margin(3e-3));
    CHECK(gap(2, 0) == gap(0, 2));
    CHECK(gap(2, -1) == Approx(2.95));
    CHECK(gap(2, std::nullopt) == std::min({gap(2, 0), gap(2, 1), gap(2, 2), gap(2, -2)}));
    CHECK(gap(0, std::nullopt) == std::min(gap(0, 1), gap(0, -1)));
}

TEST_CASE("Touches: all that overlaps is listed, the deepest first", "[assembly][touch]") {
    const Problem problem =
        test::read(test::replaced(test::replaced(heap, "from = [0, 0, 0.07]", "from = [0, 0, 0.03]"),
                                  "from = [0, 0.115",
                                  "from = [0, 0.09"));
    const System system(problem.model);
    State state = system.initial_state();
    contact_assembly_of(system)->search(state);
    const std::vector<ContactOverlap> overlaps = contact_assembly_of(system)->list_overlaps(state, 0.0);
    REQUIRE(overlaps.size() == 2);
    CHECK(overlaps[0].rods == std::array{0, -1});
    CHECK(overlaps[0].gap == Approx(-0.02));
    CHECK(overlaps[1].rods == std::array{0, 1});
    CHECK(overlaps[1].gap < 0.0);
    CHECK(overlaps[1].gap > overlaps[0].gap);
    const std::string text = contact_assembly_of(system)->describe_overlap(state, 0.0);
    CHECK(text.starts_with("a@0 is 0.02 deep in obstacle \"floor\""));
    CHECK(text.find("; 1 more pair overlaps: a and b by ") != std::string::npos);
}
