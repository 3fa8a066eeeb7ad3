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

std::vector<RoundTrip> rest_trips() {
    return {{"rod.NAME.rest.curvature", with(rod_deck, "[0.5, 0, \"s\"]"), [](const Problem& p) {
                 const std::vector<Vec6>& strains = p.model.rods[0].rest_strains;
                 return strains.size() == 10 && std::abs(strains[2][3] + 0.5) < 1e-14 &&
                        std::abs(strains[2][5] + 2.5) < 1e-14;
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
    CHECK_THROWS_WITH(read(replaced(ring(), "element = ", "rest = { }\nelement = ")),
                      Contains("rod.r.rest.curvature: missing"));
}

}  // namespace gxrod::test
