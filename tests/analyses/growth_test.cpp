#include "deck/decks.hpp"
#include "face/simulation.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// A cantilever of 2 that grows by a part of its length, and then carries a small force across its end.
Simulation grow(const std::string& part) {
    return Simulation(read(R"deck([section.s]
stiffness = { EA = 1e3, GAy = 1e9, GAz = 1e9, GJ = 5, EIy = 6, EIz = 6 }
inertia = { rhoA = 2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.arm]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
order = 3
[[support]]
at = "arm.start"
fix = "all"
[[actuation]]
on = "arm"
stretch = ")deck" + part + R"deck("
[[load]]
at = "arm.end"
force = [0, 0, -1e-6]
[[history]]
name = "tip"
at = "arm.end"
quantities = ["displacement"]
[analysis]
kind = "static"
steps = 2
)deck"));
}

}  // namespace

// What the guide says of growth: the stiffness belongs to the length before, so that the end sinks by F L³/(3
// EI) (1 + g)², not by (1 + g)³ as that of a longer rod of this section.
TEST_CASE("A rod that grows is free of force, and keeps the stiffness of its length before", "[analyses]") {
    Simulation grown = grow("0.1*t");
    grown.run();
    const Vec3 tip = grown["tip"].displacement;
    CHECK(tip.x() == Approx(0.2).epsilon(1e-9));
    CHECK(tip.z() == Approx(-1e-6 * 8.0 / 18.0 * 1.21).epsilon(1e-7));
    CHECK(grown.ledger().strain_energy == Approx(0.0).margin(1e-11));
}

}  // namespace gxrod::test
