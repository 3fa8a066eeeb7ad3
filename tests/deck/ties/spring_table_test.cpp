#include "deck/ties/ties.hpp"

#include "deck/decks.hpp"
#include "model/spring_law.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::string spring(const std::string& lines) { return "[spring.s]\n" + lines; }

// A rod from x = 0 to 10, and a body at (0, 0, 2); lines 1 to 16, the spring's keys begin in line 18.
const std::string parts = rod_deck + "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [0, 0, 2]\n";

}  // namespace

TEST_CASE("A spring is between the places that the deck says", "[deck]") {
    const Problem problem =
        read(parts + spring("between = [\"r@0.25\", \"b\"]\nat_b = [0, 3, 2]\nstiffness = 7\n") +
             "[spring.t]\nbetween = [\"ground\", \"r.end\"]\nat_a = [10, 0, 5]\ndamping = 3\nlength = 4\n");
    const std::vector<Spring>& springs = problem.model.springs;
    REQUIRE(springs.size() == 2);
    const Model& model = problem.model;
    CHECK(model.nodes[springs[0].ends[0].node].position == Vec3(2.5, 0.0, 0.0));  // a node of its own
    CHECK(springs[0].ends[0].arm == Vec3::Zero());
    CHECK(springs[0].ends[1].node == model.bodies[0].node);
    CHECK(springs[0].ends[1].arm == Vec3(0.0, 3.0, 0.0));
    CHECK(springs[0].length == Vec3(-2.5, 3.0, 2.0).norm());
    CHECK(springs[0].stiffness == 7.0);
    CHECK(springs[0].damping == 0.0);
    CHECK(springs[1].ends[0].is_ground());
    CHECK(find_place(model, springs[1].ends[0]) == Vec3(10.0, 0.0, 5.0));
    CHECK(springs[1].length == 4.0);
    CHECK(springs[1].damping == 3.0);
}

TEST_CASE("Ends of springs that cannot be are errors", "[deck]") {
    const auto faults = [](const std::string& lines) { return faults_of(parts + spring(lines)); };
    const std::string k = "stiffness = 1\n";
    CHECK(faults("between = [\"r.end\", \"bb\"]\n" + k) ==
          "x.toml:18:21: spring.s.between[1]: no point \"bb\"; the deck has r.start, r.end, b");
    CHECK(faults("between = [\"r.end\", \"grund\"]\n" + k) ==
          "x.toml:18:21: spring.s.between[1]: no point \"grund\"; did you mean \"ground\"?");
    CHECK(faults("between = [\"r.end\", \"r@1\"]\n" + k) ==
          "x.toml:18:11: spring.s.between: \"r.end\" and \"r@1\" are one node, whose points keep their "
          "distance");
    CHECK(faults("between = [\"ground\", \"ground\"]\nat_a = [0, 0, 0]\nat_b = [1, 0, 0]\n" + k) ==
          "x.toml:18:11: spring.s.between: both ends are on the ground; expected a point that moves, too");
    CHECK(faults("between = [\"ground\", \"b\"]\n" + k) ==
          "x.toml:18:12: spring.s.between[0]: the ground has no place of its own; expected at_a = [x, y, z]");
    CHECK(
        faults("between = [\"b\", \"r.start\", \"r.end\"]\n" + k) ==
        "x.toml:18:11: spring.s.between: expected an array of 2 points, such as [\"arm.end\", \"body\"], or "
        "of one and \"ground\", found an array of 3");
    CHECK(faults("between = [\"b\", \"r.end\"]\n") ==
          "x.toml:17:1: spring.s: missing; expected stiffness or damping or force");
    CHECK(faults("between = [\"b\", \"r.end\"]\nstiffness = -1\n") ==
          "x.toml:19:13: spring.s.stiffness: expected a number at least 0, found -1");
}

TEST_CASE("A spring between points at one place only pulls", "[deck]") {
    const auto faults = [](const std::string& lines) {
        return faults_of(parts + spring("between = [\"b\", \"r.start\"]\nat_a = [0, 0, 0]\n" + lines));
    };
    CHECK(faults("stiffness = 1\nlength = 0\n").empty());
    CHECK(faults("stiffness = 1\n") ==
          "x.toml:18:11: spring.s.between: the points are at one place at t = 0, so that the spring has no "
          "length; expected points apart, or length = 0 for a spring that pulls them together");
    CHECK(faults("stiffness = 1\nlength = 1\n") ==
          "x.toml:21:10: spring.s.length: the points are at one place at t = 0, where a spring that pushes "
          "them apart has no direction; expected points apart, or length = 0");
    CHECK(faults("stiffness = 1\nlength = 0\ndamping = 1\n") ==
          "x.toml:22:11: spring.s.damping: the points are at one place at t = 0, where a damper has no "
          "direction; expected points apart, or no damping");
}

TEST_CASE("Histories of springs have their quantities, and points theirs", "[deck]") {
    const std::string deck = parts + spring("between = [\"b\", \"r.start\"]\nstiffness = 1\n");
    const auto history = [](const std::string& at, const std::string& quantity) {
        return "[[history]]\nname = \"h\"\nat = \"" + at + "\"\nquantities = \"" + quantity + "\"\n";
    };
    const Problem problem = read(deck + history("s", "axial_force"));
    CHECK(is_tie(problem.output.histories[0].target, TieKind::spring));
    CHECK(std::get<WatchedTie>(problem.output.histories[0].target).index == 0);
    CHECK(faults_of(deck + history("s", "position")) ==
          "x.toml:23:14: history[0].quantities: \"position\": only points have it; this is a spring");
    CHECK(faults_of(deck + history("b", "elongation")) ==
          "x.toml:23:14: history[0].quantities: \"elongation\": only springs have it; this is a point");
}

TEST_CASE("A spring's name is no point's", "[deck]") {
    CHECK(faults_of(parts + "[spring.b]\nbetween = [\"b\", \"r.end\"]\nstiffness = 1\n") ==
          "x.toml:17:1: spring.b: body.b has this name too, and points go by it");
}

TEST_CASE("A spring's force is an expression or a table of its length and rate", "[deck]") {
    const std::string law =
        "[function.law]\ntable = [[0, -30], [2, 0], [3, 90]]\n"
        "[spring.s]\nbetween = [\"b\", \"r.start\"]\n";  // 2 long; lines 17 to 20
    const auto force = [](const Problem& problem, double length, double rate) {
        return (*problem.model.springs.at(0).law)(length, rate);
    };
    const Problem table = read(parts + law + "force = \"law(length)\"\n");
    CHECK(force(table, 2.5, 7.0) == 45.0);
    CHECK(!table.model.springs[0].law->has_rate());
    CHECK(table.model.springs[0].law->start() == 2.0);
    const Problem both = read(parts + law + "force = \"law(length) + 4*rate*abs(rate)\"\n");
    CHECK(force(both, 2.5, -3.0) == 9.0);
    CHECK(both.model.springs[0].law->has_rate());
    CHECK(force(read(parts + law + "force = 5\n"), 9.0, 1.0) == 5.0);
    CHECK(
        faults_of(parts + law + "force = \"2*t\"\n") ==
        "x.toml:21:9: spring.s.force: \"2*t\": \"t\" (time) is not allowed here: this value is a function of "
        "length and rate");
    CHECK(faults_of(parts + law + "force = \"lenght\"\n") ==
          "x.toml:21:9: spring.s.force: \"lenght\": unknown name \"lenght\"; did you mean \"length\"? "
          "available: pi, length, rate");
    CHECK(faults_of(parts + law + "force = \"1/(length - 2)\"\n") ==
          "x.toml:21:9: spring.s.force: is inf at t = 0, with length = 2 and rate = 0");
    CHECK(
        faults_of("[parameters]\nrate = 1\n" + parts + law + "force = \"rate\"\n") ==
        "x.toml:23:9: spring.s.force: \"rate\": \"rate\" is the rate of the spring's length here and also a "
        "parameter; give the parameter another name");
    CHECK(faults_of(parts + "[spring.s]\nbetween = [\"b\", \"r.start\"]\nat_a = [0, 0, 0]\nlength = 0\n"
                            "force = \"length\"\n") ==
          "x.toml:21:9: spring.s.force: the points are at one place at t = 0, where a force along the spring "
          "has no direction; expected points apart, or no force");
}

}  // namespace gxrod::test
