#include "deck/sections/rest_shape.hpp"

#include <cmath>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A ring of the radius 2 about z, its sections y towards z.
std::string ring() {
    return replaced(static_rod_deck,
                    "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                    "arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [2, 0, 0], angle = \"2*pi\" }\n"
                    "order = 3\ny_axis = [0, 0, 1]");
}

std::string with(const std::string& deck, const std::string& rest) {
    return replaced(deck, "element = ", "rest = { curvature = " + rest + " }\nelement = ");
}

std::vector<Vec6> strains_of(const std::string& deck) { return read(deck).model.rods[0].rest_strains; }

Vec6 bent(const Vec3& curvature) {
    Vec6 strain = Vec6::Zero();
    strain.tail<3>() = curvature;
    return strain;
}

}  // namespace

namespace {

// The rod along x, ten long, with this rest.
std::string resting(const std::string& rest) {
    return replaced(rod_deck, "element = ", "rest = { " + rest + " }\nelement = ");
}

bool is_drawn(const Problem& p) { return p.model.rods[0].rest_positions.size() == 20; }

}  // namespace

std::vector<RoundTrip> rest_trips() {
    const std::string line = "line = { from = [1, 2, 3], to = [1, 2, 9] }";
    const std::string hung = "catenary = { from = [0, 0, 9], to = [8, 0, 9], length = 13, bed = true }";
    const Vec3 y = Vec3(1, 1, 0).normalized();
    return {{"rod.NAME.rest.y_axis",
             resting(line + ", y_axis = [1, 1, 0]"),
             [=](const Problem& p) {
                 return is_drawn(p) && (p.model.rods[0].rest_triads[0] * Vec3::UnitY() - y).norm() < 1e-14;
             }},
            {"rod.NAME.rest.twist",
             resting(line + ", twist = 0.5"),
             [](const Problem& p) {
                 const std::vector<Quat>& triads = p.model.rods[0].rest_triads;
                 return is_drawn(p) && std::abs(triads.front().angularDistance(triads.back()) - 0.5) < 1e-12;
             }},
            {"rod.NAME.rest.catenary.bed",
             replaced(resting(hung), "[rod.r]", "fluid = { outer_diameter = 0.2 }\n[rod.r]") +
                 "[seabed]\nz = 5\nstiffness = 1e3\n",
             // Half the diameter above the bed.
             [](const Problem& p) {
                 return is_drawn(p) && std::abs(p.model.rods[0].rest_positions[10].z() - 5.1) < 1e-9;
             }}};
}

TEST_CASE("a strip that is closed to a ring is bent by its curvature", "[deck][sections]") {
    CHECK(strains_of(ring()).empty());
    const std::vector<Vec6> strains = strains_of(with(ring(), "[0, 0, 0]"));
    REQUIRE(strains.size() == 30);
    // The tangent turns towards the centre, which is section −z: y is up, x goes round, z points outwards.
    const Model model = read(ring()).model;
    const Mat3 axes = model.rods[0].triads.front().toRotationMatrix();
    const Vec3 expected = axes.transpose() * Vec3(0.0, 0.0, 0.5);
    CHECK(std::abs(expected.y()) == Approx(0.5).epsilon(1e-12));
    for (const Vec6& strain : strains) CHECK((strain - bent(expected)).norm() < 1e-10);
    // A rest of the ring itself is no strain.
    for (const Vec6& strain : strains_of(with(ring(), "[0, 0.5, 0]"))) CHECK(strain.norm() < 1e-10);
}

TEST_CASE("the twist and the helix of a start are strains against a straight rest", "[deck][sections]") {
    const std::string twisted = replaced(rod_deck, "elements = 10", "elements = 10\ntwist = 2");
    for (const Vec6& strain : strains_of(with(twisted, "[0, 0, 0]")))
        CHECK((strain - bent({0.2, 0.0, 0.0})).norm() < 1e-11);
    // Radius R and pitch 2π c: curvature R/(R² + c²); parallel axes have no twist.
    const std::string helix = replaced(static_rod_deck,
                                       "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                                       "helix = { centre = [0, 0, 0], axis = [0, 0, 1], from = [2, 0, 0], "
                                       "turns = 3, pitch = \"2*pi*0.5\" }");
    for (const Vec6& strain :
         strains_of(with(replaced(helix, "elements = 10", "elements = 60"), "[0, 0, 0]"))) {
        CHECK(strain.head<4>().norm() < 1e-10);
        CHECK(strain.tail<2>().norm() == Approx(2.0 / 4.25).epsilon(1e-10));
    }
}

TEST_CASE("the rest of a line follows the arc length", "[deck][sections]") {
    const std::vector<Vec6> strains = strains_of(with(static_rod_deck, "[0, \"s\", \"x + 1\"]"));
    REQUIRE(strains.size() == 10);
    for (int e = 0; e < 10; ++e) CHECK((strains[e] + bent({0.0, e + 0.5, e + 1.5})).norm() < 1e-12);
}

TEST_CASE("what is wrong with a rest is said", "[deck][sections]") {
    CHECK_THROWS_WITH(read(with(ring(), "[0, 0, \"1/(s - s)\"]")), Contains("rod.r.rest.curvature[2]"));
    CHECK_THROWS_WITH(read(with(ring(), "[0, 0]")), Contains("rod.r.rest.curvature: expected an array of 3"));
    const auto said = [](const std::string& keys) { return Catch::Contains(keys); };
    CHECK_THROWS_WITH(read(resting("")), said("rod.r.rest: ") && said("curvature"));
    const std::string line = "line = { from = [0, 0, 0], to = [9, 0, 0] }";
    CHECK_THROWS_WITH(read(resting("curvature = [0, 0, 0], " + line)),
                      said("rod.r.rest") && said("curvature"));
    CHECK_THROWS_WITH(read(resting("curvature = [0, 0, 0], twist = 1")),
                      said("rod.r.rest.twist: curvature is"));
    CHECK_THROWS_WITH(read(resting("line = { from = [0, 0, 0], to = [0, 0, 0] }")),
                      said("rod.r.rest.line.to: the rod has no length"));
    CHECK_THROWS_WITH(read(resting("mesh = { file = \"a.msh\", group = 1 }")),
                      said("rod.r.rest.mesh: unknown key"));
}

TEST_CASE("a rest has the corners of the start", "[deck][sections]") {
    const auto bent = [](const std::string& start, const std::string& rest) {
        return replaced(resting(rest), "line = { from = [0, 0, 0], to = [10, 0, 0] }\n", start + "\n");
    };
    const std::string corner = "polyline = [[0, 0, 0], [4, 0, 0], [4, 6, 0]]\ny_axis = [0, 0, 1]";
    // Another length, another place: the same corner seen from the section.
    const Rod rod =
        read(bent(corner, "polyline = [[0, 0, 1], [0, 0, 9], [12, 0, 9]], y_axis = [0, 1, 0]")).model.rods[0];
    CHECK(rod.length == Approx(20.0));
    CHECK(rod.start_stretch == Approx(0.5));
    CHECK(rod.arc_length.back() == Approx(20.0));
    CHECK_THROWS_WITH(
        read(bent(corner, "line = { from = [0, 0, 0], to = [9, 0, 0] }")),
        Contains("x.toml:9:8: rod.r.rest: corners are rigid, but at 0.4 of the length the rest turns by 0° "
                 "and the start by 90°"));
    CHECK_THROWS_WITH(read(bent(corner, "polyline = [[0, 0, 0], [4, 0, 0], [4, -6, 0]]")),
                      Contains("turns by 90° and the start by 90° another way"));
    CHECK_THROWS_WITH(read(bent(corner, "polyline = [[0, 0, 0], [5, 0, 0], [5, 5, 0]]")),
                      Contains("corners are rigid"));
    CHECK_THROWS_WITH(
        read(replaced(bent("line = { from = [0, 0, 0], to = [10, 0, 0] }",
                           "arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1, 0, 0], angle = 6 }"),
                      "elements = 10",
                      "elements = 1")),
        Contains("rod.r.rest: the rest is bent and twisted by 343.8° within one element of order 1"));
}

TEST_CASE("a rest has the rod's own y_axis where it names none", "[deck][sections]") {
    const std::string start = replaced(resting("line = { from = [0, 0, 0], to = [0, 9, 0] }"),
                                       "elements = 10",
                                       "elements = 10\ny_axis = [0, 0, 1]");
    const Model model = read(start).model;
    CHECK((model.rods[0].rest_triads[0] * Vec3::UnitY() - Vec3::UnitZ()).norm() < 1e-14);
    CHECK_THROWS_WITH(
        read(replaced(start, "[0, 0, 1]", "[0, 1, 0]")),
        Contains("rod.r.rest.y_axis: missing; that of the rod is parallel to the start of the rest"));
}

}  // namespace gxrod::test
