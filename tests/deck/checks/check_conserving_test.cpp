#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string free_deck = rod_deck + "integrator = \"energy-momentum\"\n";

}  // namespace

TEST_CASE("energy-momentum says what it is not for", "[deck]") {
    const auto fault = [](const std::string& what) {
        return "x.toml:13:14: analysis.integrator: \"energy-momentum\" is for one free elastic body of rods, "
               "without supports, joints or damping; this model has " +
               what + "; expected another integrator, such as \"gauss-4\"";
    };
    CHECK(faults_of(free_deck + "[[support]]\nat = \"r.start\"\nfix = [\"x\"]\n") == fault("supports"));
    CHECK(faults_of(replaced(free_deck, "[rod.r]", "damping = { mass_proportional = 0.1 }\n[rod.r]"))
              .find("this model has damping") != std::string::npos);
    CHECK(faults_of(free_deck + "[body.b]\nmass = 1\ninertia = [1, 1, 1]\n") == fault("several parts"));
    CHECK(faults_of(free_deck +
                    "[spring.s]\nbetween = [\"r.start\", \"r.end\"]\nstiffness = 1\ndamping = 1\n") ==
          fault("damping"));
    CHECK(
        faults_of(replaced(body_deck, "steps = 10", "steps = 10\nintegrator = \"energy-momentum\"")) ==
        "x.toml:8:14: analysis.integrator: \"energy-momentum\" is for one free elastic body of rods, without "
        "supports, joints or damping; this model has no rods; expected another integrator, such as "
        "\"gauss-4\"");
    CHECK(faults_of(replaced(free_deck, "energy-momentum", "energy-momentun")).find("did you mean") !=
          std::string::npos);
    CHECK(faults_of(free_deck + "beta = 0.3\n").find("energy-momentum") != std::string::npos);
}

}  // namespace gxrod::test
