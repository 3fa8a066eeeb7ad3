#include <fmt/format.h>

#include <cmath>
#include <complex>

#include "deck/decks.hpp"
#include "face/gxrod.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A cantilever along x of length 2 with a force down at its end.
std::string make_cantilever(const std::string& root) {
    return R"([section.s]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 50, EIy = 60, EIz = 70 }
inertia = { rhoA = 1, rhoJ = 2e-4, rhoIy = 1e-4, rhoIz = 1e-4 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
order = 3
y_axis = [0, 1, 0]
[[load]]
at = "r.end"
force = [0, 0, -1e-3]
[[history]]
name = "root"
at = "r.start"
quantities = ["displacement", "rotation_vector", "reaction_force", "reaction_moment"]
[[history]]
name = "tip"
at = "r.end"
quantities = ["displacement"]
)" + root;
}

const std::string statics = "[analysis]\nkind = \"static\"\nsteps = 1\n";

// A mass of 2 that yields along x, pushed by 3.
const std::string yielding_mass = R"([body.top]
mass = 2.0
inertia = [1, 1, 1]
[[support]]
at = "top"
fix = ["y", "z", "rotation"]
stiffness = { x = 50 }
damping = { x = 3 }
[[load]]
at = "top"
force = [3, 0, 0]
[[history]]
name = "h"
at = "top"
quantities = ["displacement", "velocity", "acceleration", "reaction_force"]
)";

}  // namespace

TEST_CASE("A clamp that yields turns by moment over stiffness", "[deck]") {
    constexpr double F = 1e-3, L = 2.0, EI = 60.0, GA = 1e6, c = 25.0;
    Simulation run(Deck::from_text(make_cantilever("[[support]]\nat = \"r.start\"\n"
                                                   "fix = [\"position\", \"rx\", \"rz\"]\n"
                                                   "stiffness = { ry = 25 }\n" +
                                                   statics))
                       .build());
    run.run();
    CHECK(run["root"].rotation_vector.y() == Approx(F * L / c).epsilon(1e-7));
    CHECK(run["tip"].displacement.z() ==
          Approx(-F * (L * L * L / (3.0 * EI) + L * L / c + L / GA)).epsilon(1e-7));
    const Vec3 force = run["root"]["reaction_force"].vector();
    const Vec3 moment = run["root"]["reaction_moment"].vector();
    CHECK(force.z() == Approx(F).epsilon(1e-9));
    CHECK(moment.y() == Approx(-F * L).epsilon(1e-7));
}

TEST_CASE("A support yields along its own axes", "[deck]") {
    // Rows x, y, z of the support: y is (−0.6, 0, 0.8).
    Simulation run(Deck::from_text(make_cantilever("[[support]]\nat = \"r.start\"\n"
                                                   "fix = [\"x\", \"z\", \"rotation\"]\n"
                                                   "stiffness = { y = 40 }\n"
                                                   "axes = [[0.8, 0, 0.6], [-0.6, 0, 0.8], [0, -1, 0]]\n" +
                                                   statics))
                       .build());
    run.run();
    const Vec3 expected = -0.8 * 1e-3 / 40.0 * Vec3(-0.6, 0.0, 0.8);
    CHECK((run["root"].displacement.vector() - expected).norm() < 1e-7 * expected.norm());
    CHECK((run["root"]["reaction_force"].vector() - Vec3(0, 0, 1e-3)).norm() < 1e-10);
}

TEST_CASE("A column on a base that turns buckles at kL tan kL = cL/EI", "[deck]") {
    constexpr double L = 2.0, EI = 60.0, c = 45.0;
    Simulation run(
        Deck::from_text(
            replaced(make_cantilever("[[support]]\nat = \"r.start\"\nfix = [\"position\", \"rx\", \"rz\"]\n"
                                     "stiffness = { ry = 45 }\n"
                                     "[analysis]\nkind = \"buckling\"\ncount = 1\n"),
                     "force = [0, 0, -1e-3]",
                     "force = [-1, 0, 0]"))
            .build());
    const double critical = std::get<BucklingRecord>(run.run().shapes.at(0).record).factors.at(0).factor;
    const double kL = L * std::sqrt(critical / EI);
    CHECK(kL * std::tan(kL) == Approx(c * L / EI).epsilon(1e-4));
}

TEST_CASE("Reactions have the force of a support's damper, too", "[deck]") {
    Simulation run(Deck::from_text(yielding_mass +
                                   "[analysis]\nkind = \"dynamic\"\nend_time = 0.5\nsteps = 20\n"
                                   "integrator = \"newmark-ibrahimbegovic\"\n")
                       .build());
    while (run.step()) {
        const double spring = -50.0 * run["h"].displacement.x() - 3.0 * run["h"].velocity.x();
        CHECK(run["h"]["reaction_force"].vector().x() == Approx(spring).epsilon(1e-12));
        CHECK(2.0 * run["h"].acceleration.x() == Approx(3.0 + spring).epsilon(1e-8));
    }
    CHECK(run.ledger().energy_error == Approx(0.0).margin(1e-10));
}

TEST_CASE("The response has the reaction of a support that yields", "[deck]") {
    Simulation run(Deck::from_text(yielding_mass +
                                   "[analysis]\nkind = \"response\"\nomega = { values = [4.4] }\n"
                                   "excite = [{ at = \"top\", force = [1, 0, 0] }]\n")
                       .build());
    const Response& response = std::get<ResponseRecord>(run.run().shapes.at(0).record).responses.at(0);
    const std::complex<double> x(response.motion.real[0][0], response.motion.imaginary[0][0]);
    const std::complex<double> force(response.reactions.real[0][0], response.reactions.imaginary[0][0]);
    const std::complex<double> expected = -(50.0 + 3.0 * std::complex<double>(0.0, response.omega)) * x;
    CHECK(std::abs(x) > 0.01);
    CHECK(std::abs(force - expected) < 1e-10 * std::abs(expected));
}

TEST_CASE("A component yields, or is held", "[deck]") {
    const std::string support = body_deck + "[[support]]\nat = \"top\"\n";
    CHECK(faults_of(support + "fix = [\"z\"]\nstiffness = { x = 1, z = 2 }\n") ==
          "x.toml:11:26: support[0].stiffness.z: this support fixes z here too; a component is fixed, moved "
          "or yields; expected it in one place");
    CHECK(faults_of(support + "damping = { y = 2 }\n[[support]]\nat = \"top\"\nmove = { y = \"t\" }\n") ==
          "x.toml:10:17: support[0].damping.y: support[1] moves y here too; a component is fixed, moved or "
          "yields; expected it in one place");
    CHECK(faults_of(support + "fix = \"z\"\nstiffness = { x = 1, z = 0 }\n").empty());
    CHECK(faults_of(support + "stiffness = { x = 0 }\n") ==
          "x.toml:10:13: support[0].stiffness: all components are 0; expected one that is not, such as { z = "
          "1e6 }");
    CHECK(faults_of(support + "stiffness = { x = -1 }\n") ==
          "x.toml:10:19: support[0].stiffness.x: expected a number at least 0, found -1");
    CHECK_THAT(faults_of(support + "stiffness = { ry = 3 }\nfix = \"rx\"\n"),
               Contains("rx alone cannot be fixed"));
    const std::string staged = replaced(support, "[analysis]", "[[stage]]\nname = \"a\"");
    CHECK(
        faults_of(staged + "stiffness = { x = 1 }\nstages = [\"a\"]\n") ==
        "x.toml:12:10: support[0].stages: a support that yields acts in all stages, as springs do; expected "
        "no stages, or fix in a table of its own");
}

TEST_CASE("gxrod check lists supports that yield", "[deck]") {
    const Problem problem =
        read(body_deck + "[[support]]\nat = \"top\"\nfix = \"z\"\nstiffness = { x = 1e3, ry = 2 }\n");
    REQUIRE(problem.model.bushings.size() == 1);
    CHECK(problem.model.bushings[0].name == "support[0]");
    CHECK(problem.model.supports.size() == 1);
}

}  // namespace gxrod::test
