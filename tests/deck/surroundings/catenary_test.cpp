#include <algorithm>
#include <cmath>

#include "deck/surroundings/surroundings_decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

std::string hung(const std::string& keys, const std::string& more = "") {
    const std::string line = "line = { from = [0, 0, 0], to = [10, 0, 0] }";
    return replaced(tube_deck(""), line, "catenary = { " + keys + " }\ntwist = 0.3\norder = 2\n") + more;
}

const std::string symmetric = "from = [0, 0, 2], to = [8, 6, 2], length = 14";
const std::string bed = "[seabed]\nz = 0\nstiffness = 1e7\n";

}  // namespace

TEST_CASE("Without gravity a hung line is a catenary that is straight where it is free of stress", "[deck]") {
    const Model model = read(replaced(hung(symmetric), gravity_down, "")).model;
    const Rod& rod = model.rods[0];
    CHECK(rod.length == 14.0);
    // z = c cosh(x/c) with the length 2 c sinh(span/(2 c)) = 14 over the span 10, by bisection.
    double low = 1.0, high = 100.0;
    for (int i = 0; i < 200; ++i) {
        const double c = 0.5 * (low + high);
        (2.0 * c * std::sinh(5.0 / c) > 14.0 ? low : high) = c;
    }
    const double c = low;
    for (std::size_t i = 0; i < rod.nodes.size(); ++i) {
        const double s = 14.0 * static_cast<double>(i) / 8.0 - 7.0;
        const double x = c * std::asinh(s / c);
        const double z = 2.0 + c * (std::cosh(x / c) - std::cosh(5.0 / c));
        const Vec3 at = model.nodes[static_cast<std::size_t>(rod.nodes[i])].position;
        CHECK((at - Vec3(0.8 * (x + 5.0), 0.6 * (x + 5.0), z)).norm() < 1e-12);
    }
    // Its curvature c/(c² + s²) and its twist are strains of the start. Section y and z are turned by the
    // twist, so that what bends about the level normal is parted to them.
    REQUIRE(rod.rest_strains.size() == 8);
    for (std::size_t i = 0; i < 8; ++i) {
        const double point = (i % 2 == 0 ? -1.0 : 1.0) / std::sqrt(3.0);
        const double s = 14.0 * (static_cast<double>(i / 2) + 0.5 * (1.0 + point)) / 4.0 - 7.0;
        const Vec6& strain = rod.rest_strains[i];
        CHECK(strain.head<3>().isZero(0.0));
        CHECK(strain[3] == Approx(0.3 / 14.0).epsilon(1e-9));
        CHECK(strain.tail<2>().norm() == Approx(c / (c * c + s * s)).epsilon(1e-9));
    }
}

TEST_CASE("The rest of a hung line can be another", "[deck]") {
    const Model model = read(hung(symmetric + " }\nrest = { curvature = [0, 0, 0.1]")).model;
    const Model straight = read(replaced(hung(symmetric), gravity_down, "")).model;
    REQUIRE(straight.rods[0].rest_strains.size() == model.rods[0].rest_strains.size());
    const Vec6 difference = straight.rods[0].rest_strains[3] - model.rods[0].rest_strains[3];
    CHECK((difference.tail<3>() - Vec3(0.0, 0.0, 0.1)).norm() < 1e-12);
}

TEST_CASE("What is wrong with a hung line is said where it stands", "[deck]") {
    CHECK_THAT(faults_of(hung("from = [0, 0, 0], to = [8, 6, 0], length = 8")),
               Contains("x.toml:8") && Contains("rod.r.catenary.length") && Contains("8") && Contains("10"));
    CHECK_THAT(faults_of(hung("from = [0, 0, 0], to = [0, 0, 6], length = 9")),
               Contains("rod.r.catenary.length"));
    CHECK_THAT(faults_of(hung(symmetric + ", bed = true")),
               Contains("rod.r.catenary.bed: the deck has no [seabed]"));
    const std::string slope = "[seabed]\nplane = { point = [0, 0, 0], normal = [1, 0, 4] }\nstiffness = 1\n";
    CHECK_THAT(faults_of(hung(symmetric + ", bed = true", slope)), Contains("on horizontal ground only"));
    CHECK_THAT(faults_of(hung("from = [0, 0, -1], to = [8, 6, 2], length = 14, bed = true", bed)),
               Contains("below the bed"));
}

TEST_CASE("A hung line lies on the ground as deep as its weight sinks in, an end can be held lower",
          "[deck]") {
    const auto lowest = [](const std::string& catenary) {
        const std::string line = "line = { from = [0, 0, 0], to = [10, 0, 0] }";
        const Model model =
            read(replaced(tube_deck(), line, "catenary = { " + catenary + ", bed = true }") + bed).model;
        double z = 1e300;
        for (const Node& node : model.nodes) z = std::min(z, node.position.z());
        return z;
    };
    const double depth = 7850.0 * M_PI * (0.25 * 0.25 - 0.2 * 0.2) * 9.81 / (1e7 * 0.5);
    CHECK(lowest("from = [0, 0, 2], to = [8, 6, 2], length = 13") == Approx(0.25 - depth).epsilon(1e-12));
    CHECK(lowest("from = [0, 0, -0.1], to = [8, 6, 5], length = 14") == Approx(-0.1).epsilon(1e-14));
    CHECK_THAT(faults_of(hung("from = [0, 0, -0.8], to = [8, 6, 5], length = 14, bed = true", bed)),
               Contains("below the bed"));
}

}  // namespace gxrod::test
