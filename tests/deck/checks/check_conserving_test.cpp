#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string free_deck = rod_deck + "integrator = \"energy-momentum\"\n";

}  // namespace

TEST_CASE("energy-momentum says what it is not for", "[deck]") {
    const auto fault = [](const std::string& what) {
        return "analysis.integrator: \"energy-momentum\" scales rates so that energy balances: those of one "
               "model of rods, without motors and supports that move; this model has " +
               what + "; expected another integrator, such as \"gauss-4\"";
    };
    CHECK(faults_of(free_deck + "[[support]]\nat = \"r.start\"\nfix = [\"x\"]\n").empty());
    CHECK(faults_of(free_deck + "[[support]]\nat = \"r.start\"\nmove = { x = \"t^2\" }\n") ==
          "x.toml:13:14: " + fault("supports that move"));
    CHECK(faults_of(free_deck + "[joint.j]\ntype = \"hinge\"\nbetween = [\"ground\", \"r.start\"]\n"
                                "axis = [0, 0, 1]\nmove = \"t^2\"\n") == "x.toml:13:14: " + fault("motors"));
    CHECK(faults_of(free_deck + "[body.b]\nmass = 1\ninertia = [1, 1, 1]\n") ==
          "x.toml:13:14: " + fault("several parts"));
    CHECK(faults_of(replaced(body_deck, "steps = 10", "steps = 10\nintegrator = \"energy-momentum\"")) ==
          "x.toml:8:14: " + fault("no rods, and nothing holds it"));
    CHECK(faults_of(replaced(free_deck, "energy-momentum", "energy-momentun")).find("did you mean") !=
          std::string::npos);
    CHECK(faults_of(free_deck + "beta = 0.3\n").find("energy-momentum") != std::string::npos);
}

}  // namespace gxrod::test
