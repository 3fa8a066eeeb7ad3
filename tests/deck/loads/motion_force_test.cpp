// Loads whose force depends on where their point is and how fast it moves.

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const Vec3 place(1.0, 2.0, 3.0);
const Vec3 speed(0.1, 0.2, 0.3);

std::string load(const std::string& lines) { return "[[load]]\nat = \"top\"\n" + lines; }

const Vec3 turn(0.4, 0.5, 0.6);
const Vec3 spin(0.7, 0.8, 0.9);

const NodalLoad& first(const Problem& problem) { return problem.model.loads.at(0); }

Vec6 value_of(const MotionLoad& load, double time, double s = 0.0) {
    return load.value(time, s, {place, speed, turn, spin});
}

Vec3 force_of(const Problem& problem, double time) {
    return value_of(first(problem).by_motion, time).head<3>();
}

}  // namespace

TEST_CASE("A force has components by time and by motion", "[deck]") {
    const Problem problem = read(body_deck + "[function.f]\ntable = [[0, 0], [4, 8]]\n" +
                                 load("force = [\"3*t\", \"x + 10*vy\", \"f(z)*t - vz\"]\n"));
    CHECK(first(problem).force[0](2.0) == 6.0);
    CHECK(first(problem).force[1].is_zero());
    REQUIRE(first(problem).by_motion);
    CHECK((force_of(problem, 2.0) - Vec3(0.0, 3.0, 11.7)).norm() < 1e-14);
    CHECK(first(problem).has_force());
    CHECK(!first(problem).has_moment());
    CHECK(!first(problem).by_motion.turns);
    CHECK(!first(read(body_deck + load("force = [\"3*t\", 0, 1]\n"))).by_motion);
}

TEST_CASE("A force by motion is multiplied by its factor", "[deck]") {
    const Problem problem = read(body_deck + load("force = [\"x\", 0, 0]\nfactor = \"5*t\"\n"));
    CHECK(force_of(problem, 2.0) == Vec3(10.0, 0.0, 0.0));
}

TEST_CASE("In statics a force by motion grows, unless it has t", "[deck]") {
    const std::string deck =
        replaced(rod_deck, rod_deck.substr(rod_deck.find("[analysis]")), "[analysis]\nkind = \"static\"\n") +
        "[[support]]\nat = \"r.start\"\nfix = \"all\"\n[[load]]\nat = \"r.end\"\n";
    CHECK(force_of(read(deck + "force = [\"x\", 0, 0]\n"), 0.5).x() == 0.5);
    CHECK(force_of(read(deck + "force = [\"x*t\", 0, 0]\n"), 0.5).x() == 0.5);
    CHECK(force_of(read(deck + "force = [\"x*t^2\", 0, 0]\n"), 0.5).x() == 0.25);
}

TEST_CASE("A moment can depend on how its point turns", "[deck]") {
    const Problem problem = read(body_deck + load("moment = [\"-3*rx\", \"-wy*t\", \"2*t\"]\n"));
    CHECK((value_of(first(problem).by_motion, 2.0).tail<3>() - Vec3(-1.2, -1.6, 0.0)).norm() < 1e-14);
    CHECK(first(problem).moment[2](2.0) == 4.0);
    CHECK(first(problem).by_motion.turns);
    CHECK(first(problem).has_moment());
    CHECK(!first(problem).has_force());
}

TEST_CASE("Loads along a rod can depend on its motion", "[deck]") {
    const Problem problem = read(rod_deck +
                                 "[[load]]\non = \"r\"\nforce_per_length = [\"s\", \"-s*vy\", 0]\n"
                                 "moment_per_length = [0, 0, \"-4*wz\"]\nfactor = 2\n");
    const DistributedLoad& along = problem.model.distributed_loads.at(0);
    CHECK(along.force[0](1.0, 3.0) == 6.0);
    CHECK(along.force[1].is_zero());
    const Vec6 value = value_of(along.by_motion, 1.0, 3.0);
    CHECK((value.head<3>() - Vec3(0.0, -1.2, 0.0)).norm() < 1e-14);
    CHECK((value.tail<3>() - Vec3(0.0, 0.0, -7.2)).norm() < 1e-14);
    CHECK(along.by_motion.turns);
    CHECK(along.has_moment());
}

TEST_CASE("Forces by motion that cannot be are errors", "[deck]") {
    CHECK(faults_of(body_deck + load("force = [\"vq\", 0, 0]\n")).find("unknown name \"vq\"") !=
          std::string::npos);
    CHECK(faults_of("[parameters]\nvx = 1\n" + body_deck + load("force = [\"vx\", 0, 0]\n")) ==
          "x.toml:12:10: load[0].force[0]: \"vx\": \"vx\" is a component of the velocity here and also a "
          "parameter; "
          "give the parameter another name");
    CHECK(faults_of("[parameters]\nwx = 1\n" + body_deck + load("moment = [\"wx\", 0, 0]\n")) ==
          "x.toml:12:11: load[0].moment[0]: \"wx\": \"wx\" is a component of the angular velocity here and "
          "also a "
          "parameter; "
          "give the parameter another name");
    CHECK(faults_of(body_deck + load("force = [0, true, 0]\n")) ==
          "x.toml:10:13: load[0].force[1]: expected a number or an expression in t, x, y, z, vx, vy, vz, rx, "
          "ry, "
          "rz, wx, wy and wz, "
          "found "
          "a boolean");
}

}  // namespace gxrod::test
