#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Lines 1 to 10; text that is added begins in line 11.
std::string faults_with(const std::string& text) {
    return faults_of(replaced(static_rod_deck, "\"static\"", "\"path\"") + text);
}

}  // namespace

TEST_CASE("A path says where it ends", "[deck]") {
    CHECK(faults_with("until = { t = 1 }\n").empty());
    CHECK(faults_with("") == "x.toml:9:1: analysis.until: missing; expected a table until = { … }");
    CHECK(faults_with("until = {}\n") ==
          "x.toml:11:9: analysis.until: missing; expected t or arc or steps or points");
    CHECK(faults_with("until = { t = 0 }\n") ==
          "x.toml:11:15: analysis.until.t: a path begins at t = 0, so that it cannot end there at once");
    CHECK(faults_with("until = { t = [1, 2] }\n") ==
          "x.toml:11:15: analysis.until.t: a path begins at t = 0 and goes up first; the bounds are 1 and 2");
    CHECK(faults_with("until = { t = [2, 1] }\n") ==
          "x.toml:11:15: analysis.until.t: the first number is the lower bound; found 2 and 1");
    CHECK(faults_with("until = { t = [1, 2, 3] }\n") ==
          "x.toml:11:15: analysis.until.t: expected a number or an expression, or an array of 2: the lower "
          "and the upper bound, found an array of 3");
    CHECK(faults_with("until = { arc = 0, steps = 0 }\n") ==
          "x.toml:11:17: analysis.until.arc: expected a number greater than 0, found 0\n"
          "x.toml:11:28: analysis.until.steps: expected an integer from 1 to 1000000000000, found 0");
}

TEST_CASE("Keys of a path are for paths", "[deck]") {
    CHECK(faults_of(static_rod_deck + "branches = 1\n") ==
          "x.toml:11:1: analysis.branches: kind \"static\" does not use this key; it is for path");
    CHECK(faults_with("until = { t = 1 }\nsteps = 5\n") ==
          "x.toml:12:1: analysis.steps: kind \"path\" does not use this key; it is for dynamic, "
          "quasi-static, static, "
          "steady");
}

TEST_CASE("Steps of a path are not below the shortest one, and branches need bifurcations", "[deck]") {
    CHECK(faults_with("until = { t = 1 }\nstep = 1e-9\n") ==
          "x.toml:12:8: analysis.step: expected a number not below min_step, 1e-07; found 1e-09");
    CHECK(faults_with("until = { t = 1 }\nmin_step = 1\n") ==
          "x.toml:9:1: analysis.max_step: expected a number not below min_step, 1; found 0.2");
    CHECK(faults_with("until = { t = 1 }\ncritical = \"off\"\nbranches = 1\n") ==
          "x.toml:13:12: analysis.branches: branches leave bifurcations, which critical = \"locate\" finds");
}

TEST_CASE("A path has equilibria at displacements of points that are free, or at load factors", "[deck]") {
    const auto with = [](const std::string& target) {
        return faults_with("until = { t = 1 }\nat = [" + target +
                           "]\n[[support]]\nat = \"r.start\"\nfix = \"all\"\n");
    };
    CHECK(with("{ t = [0.5] }, { of = \"r.end\", displacement = \"x\", values = [1] }").empty());
    CHECK(with("{ of = \"r.start\", displacement = \"x\", values = [1] }") ==
          "x.toml:12:40: analysis.at[0].displacement: a support holds it");
    CHECK(with("{ of = \"q.end\", displacement = \"x\", values = [1] }") ==
          "x.toml:12:14: analysis.at[0].of: no point \"q.end\"; did you mean \"r.end\"?");
    CHECK(with("{ of = \"r.end\", t = [1] }") ==
          "x.toml:12:7: analysis.at[0].displacement: missing; expected one of \"x\", \"y\", \"z\"\n"
          "x.toml:12:7: analysis.at[0].values: missing; expected an array of numbers or expressions, one at "
          "least\n"
          "x.toml:12:23: analysis.at[0].t: of is given too; only one of them can be");
    CHECK(with("{ t = [] }") ==
          "x.toml:12:13: analysis.at[0].t: expected an array of numbers or expressions, one at least, found "
          "an empty array");
}

TEST_CASE("What controls a path is free", "[deck]") {
    const auto with = [](const std::string& control) {
        return faults_with("until = { t = 1 }\ncontrol = { of = " + control +
                           " }\n[[support]]\nat = \"r.start\"\nfix = \"all\"\n");
    };
    CHECK(with("\"r.end\", displacement = \"x\", to = 1").empty());
    CHECK(with("\"r.end\", rotation = \"x\"").empty());
    CHECK(with("\"r.start\", displacement = \"x\"") ==
          "x.toml:12:44: analysis.control.displacement: a support holds it");
    CHECK(with("\"r.start\", rotation = \"y\"") ==
          "x.toml:12:40: analysis.control.rotation: a support holds it");
    CHECK(with("\"r.end\"").find("displacement") != std::string::npos);
    CHECK(with("\"q.end\", displacement = \"x\"") ==
          "x.toml:12:18: analysis.control.of: no point \"q.end\"; did you mean \"r.end\"?");
}

TEST_CASE("A point that controls a path gets a node", "[deck]") {
    const Problem problem = read(replaced(static_rod_deck, "\"static\"", "\"path\"") +
                                 "until = { t = 1 }\ncontrol = { of = \"r@0.55\", displacement = \"y\" }\n");
    const auto& control = std::get<PathSettings>(problem.stages.front().analysis).control;
    REQUIRE(control);
    CHECK((problem.model.nodes.at(control->node).position - Vec3(5.5, 0.0, 0.0)).norm() < 1e-12);
}

TEST_CASE("Limit points are followed after a path", "[deck]") {
    const auto with = [](const std::string& first, const std::string& more, const std::string& load = "") {
        return faults_of(replaced(static_rod_deck, "[analysis]\nkind = \"static\"\n", "") + load +
                         "[[stage]]\nname = \"a\"\n" + first +
                         "[[stage]]\nname = \"b\"\nkind = \"path\"\nuntil = { t = 1 }\n" + more);
    };
    const std::string path = "kind = \"path\"\nuntil = { points = 1 }\n";
    const std::string relative = "[[load]]\nat = \"r.end\"\nforce = [1, 0, 0]\nrelative_to = \"limit\"\n";
    CHECK(with(path, "follow = \"limit\"\n", relative).empty());
    CHECK(with("kind = \"static\"\n", "follow = \"limit\"\n")
              .find("stage[1].follow: the stage before must be a path, which ends on the limit point to "
                    "follow") != std::string::npos);
    CHECK(with(path, "follow = \"limit\"\nbranches = 1\n")
              .find("stage[1].branches: a stage that follows limit points has no branches") !=
          std::string::npos);
    CHECK(with(path, "follow = \"limit\"\ncontrol = { of = \"r.end\", displacement = \"x\" }\n")
              .find("stage[1].control: a stage that follows limit points goes by its arc length") !=
          std::string::npos);
    CHECK(with(path, "", relative).find("load[0].relative_to: no stage follows a limit point") !=
          std::string::npos);
}

}  // namespace gxrod::test
