#include <cmath>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string line = "line = { from = [0, 0, 0], to = [10, 0, 0] }";

// rod_deck with another centreline, in line 6, and ten elements.
std::string with(const std::string& geometry) { return replaced(rod_deck, line, geometry); }

Vec3 end_of(const Problem& problem) {
    return problem.model.nodes[static_cast<std::size_t>(problem.model.rods[0].nodes.back())].position;
}

Vec3 tangent_at(const Problem& problem, std::size_t entry) {
    return problem.model.rods[0].triads[entry] * Vec3::UnitX();
}

}  // namespace

TEST_CASE("A rod has one centreline", "[deck]") {
    CHECK(faults_of(with("")) ==
          "x.toml:4:1: rod.r: missing; expected line = { … } or arc = { … } or helix = { … } or polyline "
          "or spline or catenary = { … } or mesh = { … }");
    CHECK(faults_of(with(line + "\nspline = [[0, 0, 0], [1, 0, 0]]")) ==
          "x.toml:7:1: rod.r.spline: line is given too; only one of them can be");
}

TEST_CASE("An arc goes through its three points", "[deck]") {
    const Problem quarter = read(with("arc = { from = [2, 0, 0], through = [0, 2, 0], to = [0, -2, 0] }"));
    CHECK(quarter.model.rods[0].length == Approx(3.0 * M_PI).epsilon(1e-15));
    CHECK((end_of(quarter) - Vec3(0, -2, 0)).norm() < 1e-14);
    CHECK((tangent_at(quarter, 0) - Vec3(0, 1, 0)).norm() < 1e-15);
    // The short way round, in another plane.
    const Problem other = read(with("arc = { from = [1, 1, 1], through = [1, 2, 2], to = [1, 3, 1] }"));
    CHECK(other.model.rods[0].length == Approx(M_PI).epsilon(1e-14));
    CHECK((end_of(other) - Vec3(1, 3, 1)).norm() < 1e-14);
    CHECK((tangent_at(other, 0) - Vec3(0, 0, 1)).norm() < 1e-14);
}

TEST_CASE("An arc turns about its centre by its angle, right-handed", "[deck]") {
    const Problem arc =
        read(with("arc = { centre = [1, 0, 0], axis = [0, 0, 5], from = [3, 0, 0], angle = \"pi/2\" }"));
    CHECK(arc.model.rods[0].length == Approx(M_PI).epsilon(1e-15));
    CHECK((end_of(arc) - Vec3(1, 2, 0)).norm() < 1e-14);
    const Problem back =
        read(with("arc = { centre = [1, 0, 0], axis = [0, 0, 5], from = [3, 0, 0], angle = \"-pi/2\" }"));
    CHECK((end_of(back) - Vec3(1, -2, 0)).norm() < 1e-14);
}

TEST_CASE("A full circle is a rod with two ends at one place", "[deck]") {
    const Problem ring =
        read(with("arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1, 0, 0], angle = \"2*pi\" }"));
    CHECK(ring.model.nodes.size() == 11);
    CHECK((end_of(ring) - Vec3(1, 0, 0)).norm() < 1e-15);
    CHECK(ring.model.rods[0].length == Approx(2.0 * M_PI).epsilon(1e-15));
}

TEST_CASE("A helix climbs by its pitch in each turn", "[deck]") {
    const std::string helix = "helix = { centre = [0, 0, 7], axis = [0, 0, 2], from = [1, 0, 0], ";
    const Problem spring = read(with(helix + "turns = 2.25, pitch = 0.5 }"));
    CHECK((end_of(spring) - Vec3(0, 1, 2.25 * 0.5)).norm() < 1e-14);
    CHECK(spring.model.rods[0].length == Approx(2.25 * std::hypot(2.0 * M_PI, 0.5)).epsilon(1e-15));
    // Left-handed, up and down; right-handed, down.
    CHECK((end_of(read(with(helix + "turns = -2.25, pitch = 0.5 }"))) - Vec3(0, -1, 1.125)).norm() < 1e-14);
    CHECK((end_of(read(with(helix + "turns = 2.25, pitch = -0.5 }"))) - Vec3(0, 1, -1.125)).norm() < 1e-14);
    CHECK((end_of(read(with(helix + "turns = -2.25, pitch = -0.5 }"))) - Vec3(0, -1, -1.125)).norm() < 1e-14);
}

TEST_CASE("A spline passes its points at its ends", "[deck]") {
    const Problem rod = read(with("spline = [[0, 0, 0], [1, 2, 0], [3, 1, \"2/2\"]]"));
    CHECK((end_of(rod) - Vec3(3, 1, 1)).norm() < 1e-14);
    CHECK(rod.model.nodes[0].position == Vec3(0, 0, 0));
    CHECK(rod.model.rods[0].length > 2.0 * std::sqrt(5.0));
}

TEST_CASE("Impossible arcs are reported", "[deck]") {
    CHECK(faults_of(with("arc = { from = [0, 0, 0], through = [1, 0, 0], to = [2, 0, 0] }")) ==
          "x.toml:6:37: rod.r.arc.through: on a line with from and to; expected a point off it");
    CHECK(faults_of(with("arc = { from = [0, 1, 0], through = [1, 0, 0], to = [0, 1, 0] }")) ==
          "x.toml:6:53: rod.r.arc.to: at the start; expected an end away from it, or centre, axis and angle");
    CHECK(faults_of(with("arc = { from = [0, 0, 0], through = [1, 0, 0] }")) ==
          "x.toml:6:7: rod.r.arc.to: missing; expected an array of 3 numbers or expressions");
    CHECK(faults_of(with("arc = { from = [0, 0, 0], through = [1, 0, 0], to = [2, 1, 0], angle = 1 }")) ==
          "x.toml:6:64: rod.r.arc.angle: goes with centre, and this table has through, with which go to");
    CHECK(
        faults_of(with("arc = { from = [1, 0, 0], centre = [0, 0, 0], axis = [0, 0, 1], to = [0, 1, 0] }")) ==
        "x.toml:6:7: rod.r.arc.angle: missing; expected a number from -6.283185307179586 to "
        "6.283185307179586 or an "
        "expression\n"
        "x.toml:6:65: rod.r.arc.to: goes with through, and this table has centre, with which go axis, angle");
    CHECK(faults_of(with(
              "arc = { from = [1, 0, 0], through = [0, 1, 0], to = [0, 1, 0], centre = [0, 0, 0], axis = [0, "
              "0, 1], angle = 1 }")) ==
          "x.toml:6:64: rod.r.arc.centre: through is given too; only one of them can be");
    CHECK(faults_of(with("arc = { from = [1, 0, 0] }")) ==
          "x.toml:6:7: rod.r.arc: missing; expected through or centre");
    const std::string centre = "arc = { centre = [0, 0, 0], axis = [0, 0, 1], ";
    CHECK(faults_of(with(centre + "from = [1, 0, 0], angle = 7 }")) ==
          "x.toml:6:73: rod.r.arc.angle: expected a number from -6.283185307179586 to 6.283185307179586, "
          "found 7");
    CHECK(faults_of(with(centre + "from = [1, 0, 0], angle = 0 }")) ==
          "x.toml:6:73: rod.r.arc.angle: expected a number other than 0");
    CHECK(faults_of(with(centre + "from = [0, 0, 2], angle = 1 }")) ==
          "x.toml:6:54: rod.r.arc.from: on the axis, so that the radius is zero; expected a point off it");
    CHECK(
        faults_of(with(centre + "from = [1, 0, 0.25], angle = 1 }")) ==
        "x.toml:6:54: rod.r.arc.from: 0.25 off the plane through centre across axis; expected a point in it");
    CHECK(faults_of(with("arc = { centre = [0, 0, 0], axis = [0, 0, 0], from = [1, 0, 0], angle = 1 }")) ==
          "x.toml:6:36: rod.r.arc.axis: expected a direction, found a vector of zero length");
}

TEST_CASE("Impossible helices are reported", "[deck]") {
    const std::string axis = "helix = { centre = [0, 0, 0], axis = [0, 0, 1], ";
    CHECK(faults_of(with(axis + "from = [1, 0, 0], turns = 0, pitch = 1 }")) ==
          "x.toml:6:75: rod.r.helix.turns: expected a number other than 0");
    CHECK(faults_of(with(axis + "from = [0, 0, 3], turns = 1, pitch = 1 }")) ==
          "x.toml:6:56: rod.r.helix.from: on the axis, so that the radius is zero; expected a point off it");
    CHECK(faults_of(with(axis + "from = [1, 0, 0], turns = 1 }")) ==
          "x.toml:6:9: rod.r.helix.pitch: missing; expected a number or an expression");
}

TEST_CASE("Impossible polylines and splines are reported by their point", "[deck]") {
    CHECK(faults_of(with("polyline = [[0, 0, 0], [1, 0, 0], [1, 0, 0]]")) ==
          "x.toml:6:35: rod.r.polyline[2]: the same point as the one before");
    CHECK(faults_of(with("polyline = [[0, 0, 0], [1, 0, 0], [0.5, 0, 0]]")) ==
          "x.toml:6:35: rod.r.polyline[2]: goes straight back; expected a corner below 180°");
    CHECK(faults_of(with("spline = [[0, 0, 0], [0, 0, 0]]")) ==
          "x.toml:6:22: rod.r.spline[1]: the same point as the one before");
    CHECK(faults_of(with("spline = [[0, 0, 0], [1, 0, 0], [0.2, 0, 0]]")) ==
          "x.toml:6:22: rod.r.spline[1]: the spline turns back on itself before this point; expected points "
          "along a "
          "smooth curve");
    CHECK(faults_of(replaced(with("polyline = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [2, 1, 0]]"),
                             "elements = 10",
                             "elements = 2")) ==
          "x.toml:7:12: rod.r.elements: expected at least 3, one for each piece between corners and the "
          "points that "
          "the deck names, found 2");
}

}  // namespace gxrod::test
