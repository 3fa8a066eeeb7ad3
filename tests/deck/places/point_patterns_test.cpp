#include "deck/places/point_patterns.hpp"

#include <algorithm>
#include <set>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

namespace {

// Two columns of 4, a beam from corner to corner in two pieces, a body on the beam.
const std::string portal = R"([section.s]
stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }
inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }
[rod.column_1]
section = "s"
line = { from = [0, 0, 0], to = [0, 0, 0.3] }
elements = 4
[rod.column_2]
section = "s"
line = { from = [1, 0, 0], to = [1, 0, 0.3] }
elements = 4
[rod.beam]
section = "s"
polyline = [[0, 0, 0.3], [0.5, 0, 0.4], [1, 0, 0.3]]
elements = 6
[body.mass]
at = "beam@0.5"
mass = 1
inertia = [1, 1, 1]
[analysis]
kind = "static"
)";

std::string support(const std::string& keys) { return "[[support]]\n" + keys + "\nfix = \"all\"\n"; }

// The names of the nodes of all supports.
std::set<std::string> supported(const std::string& keys) {
    const Model model = read(portal + support(keys)).model;
    std::set<std::string> names;
    for (const Support& one : model.supports)
        names.insert(model.nodes[static_cast<std::size_t>(one.node)].name);
    CHECK(names.size() == model.supports.size());
    return names;
}

using Names = std::set<std::string>;

}  // namespace

TEST_CASE("Supports take lists and patterns of points", "[deck]") {
    const Names feet{"column_1.start", "column_2.start"};
    CHECK(supported("at = [\"column_1.start\", \"column_2.start\"]") == feet);
    CHECK(supported("at = \"column_*.start\"") == feet);
    CHECK(supported("at = \"col*2.start\"") == Names{"column_2.start"});
    CHECK(supported("at = [\"column_*.start\", \"column_1.start\"]") == feet);
    CHECK(
        supported("at = \"*.*\"") ==
        Names{"column_1.start", "column_1.end", "column_2.start", "column_2.end", "beam.start", "beam.end"});
    CHECK(supported("at = \"ma*\"") == Names{"beam@0.5"});
}

TEST_CASE("A pattern with a fraction places nodes", "[deck]") {
    const Model model = read(portal + support("at = \"column_*@0.3\"")).model;
    REQUIRE(model.supports.size() == 2);
    CHECK(model.nodes[static_cast<std::size_t>(model.supports[1].node)].position.isApprox(Vec3(1, 0, 0.09),
                                                                                          1e-14));
}

TEST_CASE("Conditions select ends and corners, and allow for round-off", "[deck]") {
    CHECK(supported("where = \"z == 0\"") == Names{"column_1.start", "column_2.start"});
    CHECK(supported("where = \"z == 0.1 + 0.2 && x > 0.5\"") == Names{"column_2.end", "beam.end"});
    CHECK(supported("at = \"column_*\"\nwhere = \"z == 0.1 + 0.2\"") ==
          Names{"column_1.end", "column_2.end"});
    CHECK(supported("at = \"beam\"\nwhere = \"z > 0.35\"") == Names{"beam@0.5"});
    CHECK(supported("at = \"beam\"\nwhere = \"s < 0.1\"") == Names{"beam.start"});
    CHECK(supported("at = [\"column_1@0.5\", \"column_2@0.5\"]\nwhere = \"x == 1\"") ==
          Names{"column_2@0.5"});
}

TEST_CASE("Texts and conditions without a point are reported", "[deck]") {
    CHECK(faults_of(portal + support("at = \"pile*.start\"")) ==
          "x.toml:23:6: support[0].at: no point matches \"pile*.start\"; the deck has column_1.start, "
          "column_1.end, "
          "column_2.start, column_2.end, beam.start, beam.end, mass");
    CHECK(faults_of(portal + support("at = [\"column_1.start\", \"beam.ent\"]")) ==
          "x.toml:23:25: support[0].at[1]: no point \"beam.ent\"; did you mean \"beam.end\"?");
    CHECK(faults_of(portal + support("where = \"z == 7\"")) ==
          "x.toml:23:9: support[0].where: no point satisfies \"z == 7\"; the 7 points here have x 0 to 1, y "
          "0 to 0, z "
          "0 to 0.4");
    CHECK(faults_of(portal + support("where = \"z = 7\"")) ==
          "x.toml:23:9: support[0].where: \"z = 7\": \"=\" would assign; write \"==\" to compare");
    CHECK(faults_of(portal + support("where = 3")) ==
          "x.toml:23:9: support[0].where: expected a condition in x, y, z and s, such as \"z == 0 && x < "
          "2\", found 3");
    CHECK(faults_of(portal + support("axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]")) ==
          "x.toml:22:1: support[0]: missing; expected at or where");
}

TEST_CASE("Loads act at each of several points, at a node once", "[deck]") {
    const Model model =
        read(portal + "[[connect]]\npoints = \"coincident\"\n" + support("where = \"z == 0\"") +
             "[[load]]\nat = [\"column_*.end\", \"beam.*\"]\nforce = [0, 0, -1]\n")
            .model;
    REQUIRE(model.loads.size() == 2);
    CHECK(model.loads[0].node != model.loads[1].node);
    CHECK(model.loads[0].key == "load[0]");
}

TEST_CASE("Loads act along several rods, or along their elements that satisfy a condition", "[deck]") {
    const std::string load = "[[load]]\nforce_per_length = [0, 2, 0]\n";
    const Model along = read(portal + support("where = \"z == 0\"") + load + "on = \"column_*\"\n").model;
    REQUIRE(along.distributed_loads.size() == 2);
    CHECK(along.distributed_loads[1].rod == 1);
    const Model part = read(portal + support("where = \"z == 0\"") + load + "where = \"z > 0.15\"\n").model;
    REQUIRE(part.distributed_loads.size() == 3);
    // The load factor is 1.
    const LineFunction& column = part.distributed_loads[0].force[1];
    CHECK(column(1.0, 0.01) == 0.0);
    CHECK(column(1.0, 0.1499) == 0.0);
    CHECK(column(1.0, 0.1501) == 2.0);
    CHECK(column(1.0, 0.2999) == 2.0);
    CHECK(part.distributed_loads[2].force[1](1.0, 0.001) == 2.0);
    CHECK(faults_of(portal + load + "where = \"z > 9\"\n") ==
          "x.toml:24:9: load[0].where: no element of the rods here has its middle where \"z > 9\" holds");
    CHECK(faults_of(portal + "[[load]]\nwhere = \"z > 0.1\"\n") ==
          "x.toml:23:9: load[0].where: nothing acts there; expected force or moment, or force_per_length or "
          "moment_per_length");
    CHECK(faults_of(portal + load + "on = \"colum_*\"\n") ==
          "x.toml:24:6: load[0].on: no rod matches \"colum_*\"; the deck has column_1, column_2, beam");
}

TEST_CASE("Histories of several points are numbered", "[deck]") {
    const Problem problem =
        read(portal + support("where = \"z == 0\"") +
             "[[history]]\nname = \"top\"\nat = [\"column_*.end\", \"mass\"]\nquantities = \"position\"\n");
    const std::vector<HistoryRequest>& histories = problem.output.histories;
    REQUIRE(histories.size() == 3);
    CHECK(histories[0].name == "top_1");
    CHECK(histories[0].at == "column_1.end");
    CHECK(histories[1].at == "column_2.end");
    CHECK(histories[2].name == "top_3");
    CHECK(histories[2].at == "mass");
    CHECK(std::holds_alternative<WatchedBody>(histories[2].target));
}

}  // namespace gxrod::test
