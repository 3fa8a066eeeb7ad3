#include "deck/bodies/build_outlines.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::string with_looks(const std::string& looks) {
    return replaced(body_deck, "[analysis]", "looks = [" + looks + "]\n[analysis]");
}

// Two bodies and a ball joint between them, off both centres.
const char* const pair = R"([body.a]
mass = 3
inertia = [1, 2, 2.5]
centre_of_mass = [0.5, 0, 0]
[body.b]
mass = 1
inertia = [1, 1, 1]
at = [4, 0, 0]
rotation_vector = [0, 0, "pi/2"]
[joint.pin]
type = "ball"
between = ["a", "b"]
at = [2, 1, 0]
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.1
)";

}  // namespace

TEST_CASE("A body without looks is the cuboid of its mass and inertia, with lines to its joints", "[deck]") {
    const Problem problem = read(pair);
    const BodyOutline& a = problem.outlines.at(0);
    CHECK_FALSE(a.is_given);
    REQUIRE(a.points.size() == 10);
    // I_x = m/3 (b² + c²) of half edges a, b and c, about the centre of mass.
    Vec3 half = a.points[7] - Vec3(0.5, 0, 0);
    const Vec3 squares = half.cwiseAbs2();
    CHECK((3.0 / 3.0 * (Vec3::Constant(squares.sum()) - squares) - Vec3(1, 2, 2.5)).norm() < 1e-14);
    CHECK(a.points[8] == Vec3(0.5, 0, 0));
    CHECK((a.points[9] - Vec3(2, 1, 0)).norm() < 1e-14);
    CHECK(a.lines.back() == std::array{8, 9});
    // In axes of B, which are turned.
    CHECK((problem.outlines.at(1).points.at(9) - Vec3(1, 2, 0)).norm() < 1e-14);
}

TEST_CASE("Looks of a body are not forces", "[deck]") {
    const std::string sphere = "{ sphere = { radius = 2 } }";
    const Problem problem = read(with_looks(sphere + ", { box = { size = [1, 1, 1] } }"));
    CHECK(problem.model.contact.bodies.empty());
    REQUIRE(problem.outlines.size() == 1);
    CHECK(problem.outlines[0].is_given);
    CHECK(problem.outlines[0].lines.size() > 12);
}

TEST_CASE("Wrong looks of a body are errors", "[deck]") {
    const std::string path = "body.top.looks[0]";
    CHECK(faults_of(with_looks("{ box = { size = [1, 0, 1] } }")) ==
          "x.toml:4:27: " + path + ".box.size: expected three edges greater than 0");
    CHECK(faults_of(with_looks("{ cylinder = { from = [1, 0, 1], to = [1, 0, 1], radius = 1 } }")) ==
          "x.toml:4:48: " + path + ".cylinder.to: expected an end away from its start");
    CHECK(faults_of(with_looks("{}")) ==
          "x.toml:4:10: " + path +
              ": missing; expected box = { … } or cylinder = { … } or sphere = { … } or arms or "
              "mesh = { … }");
    CHECK(faults_of(with_looks("{ file = \"x.stl\" }")) ==
          "x.toml:4:12: " + path + ".file: unknown key; did you mean \"mesh\"?");
    CHECK(faults_of(with_looks("{ mesh = { file = \"absent.stl\" } }")) ==
          "x.toml:4:28: " + path + ".mesh.file: absent.stl: cannot be read (No such file or directory)");
    CHECK(faults_of(replaced(body_deck, "[analysis]", "looks = \"box\"\n[analysis]")) ==
          "x.toml:4:9: body.top.looks: expected tables looks = [{ … }, …], found the text \"box\"");
}

}  // namespace gxrod::test
