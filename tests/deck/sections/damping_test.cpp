#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

std::string with_damping(const std::string& times) {
    return "[section.s]\nstiffness = { EA = 1, GAy = 1, GAz = 1, GJ = 1, EIy = 1, EIz = 1 }\ninertia = { "
           "rhoA = 1, "
           "rhoJ = 1, rhoIy = 1, rhoIz = 1 }\ndamping = { kelvin_voigt = " +
           times +
           " }\n[rod.r]\nsection = \"s\"\nline = { from = [0, 0, 0], to = [1, 0, 0] }\nelements = "
           "1\n[analysis]\nkind "
           "= \"dynamic\"\nend_time = 1\ntime_step = 0.1\n";
}

}  // namespace

TEST_CASE("Kelvin-Voigt damping has one time, or six", "[deck]") {
    const Section even = read(with_damping("0.25")).model.sections.at(0);
    CHECK(even.kelvin_voigt == 0.25);
    CHECK(!even.kelvin_voigt_components);
    const Section uneven = read(with_damping("[0.1, 0.2, 0.3, 0.4, 0.6, \"0.1*5\"]")).model.sections.at(0);
    REQUIRE(uneven.kelvin_voigt_components);
    Vec6 expected;
    expected << 0.1, 0.2, 0.3, 0.4, 0.6, 0.5;
    CHECK((*uneven.kelvin_voigt_components - expected).norm() < 1e-15);
    CHECK(uneven.kelvin_voigt == 0.6);
    CHECK_THAT(faults_of(with_damping("[0.1, 0.2]")), Contains("or an array of 6 of them"));
    CHECK_THAT(faults_of(with_damping("[0.1, 0.2, 0.3, -0.4, 0.6, 0.5]")), Contains("kelvin_voigt[3]"));
}

}  // namespace gxrod::test
