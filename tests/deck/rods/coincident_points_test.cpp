#include "deck/rods/coincident_points.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

namespace {

const std::string section = R"([section.s]
stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }
[analysis]
kind = "static"
)";

std::string rod(const std::string& name, const std::string& keys) {
    return "[rod." + name + "]\nsection = \"s\"\nelements = 4\n" + keys + "\n";
}

// A T of two rods on a column, and a brace from the middle of the column to the end of the beam.
const std::string tee = section + rod("column", "line = { from = [0, 0, 0], to = [0, 0, 2] }") +
                        rod("left", "line = { from = [0, 0, 2], to = [-1, 0, 2] }") +
                        rod("right", "line = { from = [0, 0, 2], to = [1, 0, 2] }");
const std::string brace = "line = { from = [0, 0, 1], to = [1, 0, 2] }";
const std::string coincident = "[[connect]]\npoints = \"coincident\"\n";

}  // namespace

TEST_CASE("Coincident ends become one node", "[deck]") {
    const Model apart = read(tee).model;
    const Model model = read(tee + coincident).model;
    CHECK(apart.nodes.size() == model.nodes.size() + 2);
    CHECK(model.rods[0].nodes.back() == model.rods[1].nodes.front());
    CHECK(model.rods[0].nodes.back() == model.rods[2].nodes.front());
    CHECK(model.nodes[static_cast<std::size_t>(model.rods[0].nodes.back())].name == "column.end");
}

TEST_CASE("An end that meets a node within a rod is connected to it", "[deck]") {
    const Model model = read(tee + rod("brace", brace) + coincident).model;
    CHECK(model.rods[3].nodes.front() == model.rods[0].nodes[2]);
    CHECK(model.rods[3].nodes.back() == model.rods[2].nodes.back());
}

TEST_CASE("An end that lies on a rod between its nodes is reported", "[deck]") {
    const std::string odd = replaced(
        tee, "[rod.column]\nsection = \"s\"\nelements = 4", "[rod.column]\nsection = \"s\"\nelements = 5");
    CHECK(faults_of(odd + rod("brace", brace) + coincident) ==
          "x.toml:22:10: connect[0].points: brace.start lies on column at 0.5 of its length, within an "
          "element; a point "
          "ROD@FRACTION in a [[connect]] of both gives it a node there, as other numbers of elements can");
    const Model model = read(odd + rod("brace", brace) + coincident +
                             "[[connect]]\npoints = [\"column@0.5\", \"brace.start\"]\n")
                            .model;
    CHECK(model.nodes.size() == read(tee + rod("brace", brace) + coincident).model.nodes.size() + 1);
}

TEST_CASE("A corner that meets a node within a rod is connected to it", "[deck]") {
    const Model model = read(tee + rod("bracket", "polyline = [[0, -1, 1], [0, 0, 1], [0, 1, 1]]") +
                             rod("other", "polyline = [[0.5, -1, 2], [0.5, 0, 2], [0.5, 0, 3]]") + coincident)
                            .model;
    CHECK(model.rods[3].nodes[2] != model.rods[0].nodes[2]);  // straight there
    CHECK(model.rods[4].nodes[2] == model.rods[2].nodes[2]);
}

TEST_CASE("Rods that cross in nodes within both are not connected", "[deck]") {
    const std::string cross = section + rod("a", "line = { from = [0, 0, 0], to = [2, 0, 0] }") +
                              rod("b", "line = { from = [1, -1, 0], to = [1, 1, 0] }");
    CHECK(faults_of(cross + coincident) ==
          "x.toml:14:10: connect[0].points: no points coincide; a larger tolerance finds points that are "
          "near to each "
          "other");
    CHECK(faults_of(cross + "[[load]]\nat = \"a@0.5\"\nforce = [0, 0, 1]\n" + coincident).empty());
}

TEST_CASE("Only the rods that `on` names are connected", "[deck]") {
    const Model model = read(tee + coincident + "on = [\"col*\", \"left\"]\n").model;
    CHECK(model.rods[0].nodes.back() == model.rods[1].nodes.front());
    CHECK(model.rods[0].nodes.back() != model.rods[2].nodes.front());
}

TEST_CASE("The tolerance says how far coincident points are apart", "[deck]") {
    const std::string off =
        replaced(tee, "from = [0, 0, 2], to = [1, 0, 2]", "from = [0, 1e-4, 2], to = [1, 0, 2]");
    CHECK(read(off + coincident).model.rods[2].nodes.front() !=
          read(off + coincident).model.rods[0].nodes.back());
    const Model model = read(off + coincident + "tolerance = 1e-3\n").model;
    CHECK(model.rods[2].nodes.front() == model.rods[0].nodes.back());
    CHECK(faults_of(off + "[[connect]]\npoints = [\"column.end\", \"right.start\"]\ntolerance = 1e-3\n")
              .empty());
    CHECK(faults_of(off + "[[connect]]\npoints = [\"column.end\", \"right.start\"]\ntolerance = 1e-5\n") ==
          "x.toml:18:25: connect[0].points[1]: \"right.start\" is 0.0001 away from \"column.end\"; points "
          "that become "
          "one node must be at one place, to the tolerance of 1e-05");
}

TEST_CASE("Patterns name points to connect", "[deck]") {
    const Model model = read(tee + "[[connect]]\npoints = [\"column.end\", \"*t.start\"]\n").model;
    CHECK(model.rods[0].nodes.back() == model.rods[1].nodes.front());
    CHECK(model.rods[0].nodes.back() == model.rods[2].nodes.front());
    CHECK(faults_of(tee + "[[connect]]\npoints = [\"col*.end\"]\n") ==
          "x.toml:18:10: connect[0].points: matches \"column.end\" alone; expected two points or more");
}

TEST_CASE("Ends with hinges are tied by joints", "[deck]") {
    const Model model =
        read(tee + rod("brace", brace + "\nhinges = [\"start\", \"end\"]") + coincident).model;
    REQUIRE(model.joints.size() == 2);
    const Joint& start = model.joints[0];
    CHECK(start.name == "brace.start");
    CHECK(start.kind == JointKind::universal);
    CHECK(start.a.anchor.node == model.rods[0].nodes[2]);
    CHECK(start.b.anchor.node == model.rods[3].nodes.front());
    const Vec3 y = model.rods[3].triads.front() * Vec3::UnitY();
    const Vec3 z = model.rods[3].triads.front() * Vec3::UnitZ();
    CHECK(start.a.axes.col(0).isApprox(y, 1e-14));
    CHECK(start.b.axes.col(0).isApprox(z, 1e-14));
    CHECK(start.b.axes.determinant() == Approx(1.0));
    CHECK(model.joints[1].a.anchor.node == model.rods[2].nodes.back());
}

TEST_CASE("An end with a hinge that two tables name has one joint, and what it is tied to is one node",
          "[deck]") {
    const Model model = read(tee + rod("brace", brace + "\nhinges = \"end\"") +
                             rod("post", "line = { from = [1, 0, 2], to = [1, 0, 0] }") +
                             "[[connect]]\npoints = [\"right.end\", \"brace.end\"]\n"
                             "[[connect]]\npoints = [\"brace.end\", \"post.start\"]\n")
                            .model;
    CHECK(model.joints.size() == 1);
    CHECK(model.rods[2].nodes.back() == model.rods[4].nodes.front());
    CHECK(model.joints[0].a.anchor.node == model.rods[2].nodes.back());
}

TEST_CASE("Hinges in a plane leave its rotation free", "[deck]") {
    const Model model =
        read("plane = \"xz\"\n" + tee + rod("brace", brace + "\nhinges = \"start\"") + coincident).model;
    REQUIRE(model.joints.size() == 1);
    CHECK(model.joints[0].kind == JointKind::ball);
}

TEST_CASE("Conditions leave out nodes of hinges, whose joint has another node", "[deck]") {
    const std::string deck = tee + rod("brace", brace + "\nhinges = \"start\"") + coincident +
                             "[[support]]\nwhere = \"z == 1\"\nfix = \"position\"\n";
    CHECK(faults_of(deck) ==
          "x.toml:25:9: support[0].where: no point satisfies \"z == 1\"; the 4 points here have x -1 to 1, y "
          "0 to 0, z 0 "
          "to 2");
}

TEST_CASE("A hinge that nothing ties is refused", "[deck]") {
    CHECK(faults_of(tee + rod("brace", brace + "\nhinges = \"start\"")) ==
          "x.toml:21:10: rod.brace.hinges: no [[connect]] ties brace.start to another point; at a "
          "[[support]] a hinge "
          "is what leaves the rotations free");
}

}  // namespace gxrod::test
