// Loads whose force depends on where their point is and how fast it moves.

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const Vec3 place(1.0, 2.0, 3.0);
const Vec3 speed(0.1, 0.2, 0.3);

std::string load(const std::string& lines) { return "[[load]]\nat = \"top\"\n" + lines; }

const NodalLoad& first(const Problem& problem) { return problem.model.loads.at(0); }

}  // namespace

TEST_CASE("A force has components by time and by motion", "[deck]") {
    const Problem problem = read(body_deck + "[function.f]\ntable = [[0, 0], [4, 8]]\n" +
                                 load("force = [\"3*t\", \"x + 10*vy\", \"f(z)*t - vz\"]\n"));
    CHECK(first(problem).force[0](2.0) == 6.0);
    CHECK(first(problem).force[1].is_zero());
    REQUIRE(first(problem).motion_force);
    CHECK((first(problem).motion_force(2.0, place, speed) - Vec3(0.0, 3.0, 11.7)).norm() < 1e-14);
    CHECK(first(problem).has_force());
    CHECK(!first(read(body_deck + load("force = [\"3*t\", 0, 1]\n"))).motion_force);
}

TEST_CASE("A force by motion is multiplied by its factor", "[deck]") {
    const Problem problem = read(body_deck + load("force = [\"x\", 0, 0]\nfactor = \"5*t\"\n"));
    CHECK(first(problem).motion_force(2.0, place, speed) == Vec3(10.0, 0.0, 0.0));
}

TEST_CASE("In statics a force by motion grows, unless it has t", "[deck]") {
    const std::string deck =
        replaced(rod_deck, rod_deck.substr(rod_deck.find("[analysis]")), "[analysis]\nkind = \"static\"\n") +
        "[[support]]\nat = \"r.start\"\nfix = \"all\"\n[[load]]\nat = \"r.end\"\n";
    CHECK(first(read(deck + "force = [\"x\", 0, 0]\n")).motion_force(0.5, place, speed).x() == 0.5);
    CHECK(first(read(deck + "force = [\"x*t\", 0, 0]\n")).motion_force(0.5, place, speed).x() == 0.5);
    CHECK(first(read(deck + "force = [\"x*t^2\", 0, 0]\n")).motion_force(0.5, place, speed).x() == 0.25);
}

TEST_CASE("Forces by motion that cannot be are errors", "[deck]") {
    CHECK(faults_of(body_deck + load("force = [\"vq\", 0, 0]\n")).find("unknown name \"vq\"") !=
          std::string::npos);
    CHECK(faults_of("[parameters]\nvx = 1\n" + body_deck + load("force = [\"vx\", 0, 0]\n")) ==
          "x.toml:12:10: load[0].force[0]: \"vx\": \"vx\" is a component of the velocity here and also a "
          "parameter; "
          "give the parameter another name");
    CHECK(faults_of(body_deck + load("moment = [\"vx\", 0, 0]\n")).find("unknown name \"vx\"") !=
          std::string::npos);
    CHECK(faults_of(body_deck + load("force = [0, true, 0]\n")) ==
          "x.toml:10:13: load[0].force[1]: expected a number or an expression in t, x, y, z, vx, vy and vz, "
          "found "
          "a boolean");
}

}  // namespace gxrod::test
