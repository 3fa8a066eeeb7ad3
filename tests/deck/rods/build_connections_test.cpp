#include "deck/rods/build_connections.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

namespace {

// The place of the point of a history.
const RodPlace& place_of(const Problem& problem, std::size_t history) {
    return std::get<WatchedPoint>(problem.output.histories.at(history).target).place;
}

std::string rod(const std::string& name,
                const std::string& from,
                const std::string& to,
                const std::string& elements) {
    return "[rod." + name + "]\nsection = \"s\"\nline = { from = " + from + ", to = " + to +
           " }\nelements = " + elements + "\nelement = \"simo\"\n";
}

std::string connect(const std::string& points) { return "[[connect]]\npoints = [" + points + "]\n"; }

// Rod r from x = 0 to 10 of 10 elements, and from its end q along y and p along z, of 2 elements each; lines
// 1 to 22.
const std::string branch =
    rod_deck + rod("q", "[10, 0, 0]", "[10, 5, 0]", "2") + rod("p", "[10, 0, 0]", "[10, 0, 5]", "2");

std::string history(const std::string& name, const std::string& at) {
    return "[[history]]\nname = \"" + name + "\"\nat = \"" + at + "\"\nquantities = \"moment\"\n";
}

}  // namespace

TEST_CASE("Connected points are one node", "[deck]") {
    CHECK(read(branch).model.nodes.size() == 17);
    const Problem problem =
        read(branch + connect(R"("r.end", "q.start", "p.start")") + history("a", "p.end") +
             history("b", "q.start") + "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = \"p.start\"\n" +
             "[[load]]\nat = \"q.start\"\nforce = [1, 0, 0]\nframe = \"body\"\n");
    const Model& model = problem.model;
    REQUIRE(model.nodes.size() == 15);
    CHECK(model.nodes[10].name == "r.end");
    CHECK(model.rods[0].nodes == std::vector{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    CHECK(model.rods[1].nodes == std::vector{10, 11, 12});
    CHECK(model.rods[1].element_nodes == std::vector{10, 11, 11, 12});
    CHECK(model.rods[2].element_nodes == std::vector{10, 13, 13, 14});
    CHECK(model.nodes[14].name == "p.end");
    CHECK(model.nodes[14].position == Vec3(10, 0, 5));
    CHECK(model.bodies[0].node == 10);
    CHECK(node_of(problem.output.histories[0].target) == 14);
    CHECK((place_of(problem, 0).element == 1 && place_of(problem, 0).xi == 1.0));
    CHECK(node_of(problem.output.histories[1].target) == 10);
    CHECK((place_of(problem, 1).element == 0 && place_of(problem, 1).xi == -1.0));
    CHECK((model.loads[0].axes * Vec3::UnitX()).isApprox(Vec3::UnitY(), 1e-14));
}

TEST_CASE("Connections chain from one to the next, under the first name", "[deck]") {
    const Model model =
        read(branch + connect(R"("q.start", "p.start")") + connect(R"("r.end", "q.start")")).model;
    REQUIRE(model.nodes.size() == 15);
    CHECK(model.rods[0].nodes.back() == model.rods[2].nodes.front());
    CHECK(model.rods[1].nodes.front() == model.rods[2].nodes.front());
    CHECK(model.nodes[model.rods[0].nodes.back()].name == "q.start");
    CHECK(
        faults_of(branch + connect(R"("q.start", "p.start")") + connect(R"("p.start", "q.start")")).empty());
}

TEST_CASE("A ring of rods closes, and so does one that comes back to itself", "[deck]") {
    const std::string triangle = replaced(rod_deck, "to = [10, 0, 0]", "to = [3, 0, 0]") +
                                 rod("q", "[3, 0, 0]", "[0, 4, 0]", "2") +
                                 rod("p", "[0, 4, 0]", "[0, 0, 0]", "2") + connect(R"("r.end", "q.start")") +
                                 connect(R"("q.end", "p.start")") + connect(R"("p.end", "r.start")");
    const Model model = read(triangle).model;
    CHECK(model.nodes.size() == 14);
    CHECK(model.rods[2].nodes.back() == model.rods[0].nodes.front());
    CHECK(model.rods[2].nodes.size() == 3);
}

TEST_CASE("Points that are not at one place are not connected", "[deck]") {
    CHECK(
        faults_of(branch + connect(R"("r.end", "q.end")")) ==
        R"(x.toml:24:20: connect[0].points[1]: "q.end" is 5 away from "r.end"; points that become one node must be at one place, to 1e-09 of the model's size)");
    CHECK(
        faults_of(
            replaced(branch, "from = [10, 0, 0], to = [10, 0, 5]", "from = [10, 1e-9, 0], to = [10, 0, 5]") +
            connect(R"("r.end", "p.start")"))
            .empty());
    CHECK_FALSE(
        faults_of(
            replaced(branch, "from = [10, 0, 0], to = [10, 0, 5]", "from = [10, 1e-7, 0], to = [10, 0, 5]") +
            connect(R"("r.end", "p.start")"))
            .empty());
    CHECK(faults_of(branch + connect(R"("r.end", "r@1")")) ==
          R"(x.toml:24:20: connect[0].points[1]: "r@1" is the same point as "r.end")");
}

TEST_CASE("An element whose ends become one node is refused", "[deck]") {
    const std::string line = "line = { from = [0, 0, 0], to = [10, 0, 0] }";
    const std::string ring =
        replaced(replaced(rod_deck, line, "spline = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0]]"),
                 "elements = 10",
                 "elements = 1\norder = 4") +
        connect(R"("r.start", "r.end")");
    CHECK(faults_of(ring) ==
          "x.toml:15:10: connect[0].points: both ends of an element of rod.r become one node; give the rod "
          "two elements at "
          "least between them");
    CHECK(faults_of(replaced(ring, "elements = 1", "elements = 2")).empty());
}

TEST_CASE("Connections name two points of rods at least", "[deck]") {
    CHECK(
        faults_of(branch + connect(R"("r.end")")) ==
        R"(x.toml:24:10: connect[0].points: expected an array of points, such as ["leg.end", "beam.start"], with * for any letters, or "coincident", found an array of 1)");
    CHECK(
        faults_of(branch + "[[connect]]\npoints = \"r.end\"\n") ==
        R"(x.toml:24:10: connect[0].points: expected an array of points, such as ["leg.end", "beam.start"], with * for any letters, or "coincident", found the text "r.end")");
    CHECK(
        faults_of(branch + connect(R"("r.end", 3)")) ==
        R"(x.toml:24:20: connect[0].points[1]: expected an array of points, such as ["leg.end", "beam.start"], with * for any letters, or "coincident", found 3)");
    CHECK(faults_of(branch + connect(R"("r.end", "q.strt")")) ==
          R"(x.toml:24:20: connect[0].points[1]: no point "q.strt"; did you mean "q.start"?)");
    CHECK(
        faults_of(branch + "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [10, 0, 0]\n" +
                  connect(R"("r.end", "b")")) ==
        R"(x.toml:28:20: connect[0].points[1]: "b" is a body; expected a point of a rod; a body's `at` puts it on one)");
}

TEST_CASE("Two rods of one element each make a loop", "[deck]") {
    const std::string line = replaced(rod_deck, "elements = 10", "elements = 1");
    const std::string back = rod("q", "[10, 0, 0]", "[0, 0, 0]", "1");
    CHECK(
        faults_of(line + back + connect(R"("r.end", "q.start")") + connect(R"("q.end", "r.start")")).empty());
}

}  // namespace gxrod::test
