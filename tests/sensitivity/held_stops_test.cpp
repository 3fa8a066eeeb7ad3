// Derivatives of ropes and stops: while they hold they are those of joints, and in equilibria they go on
// through changes.
#include "deck/decks.hpp"
#include "face/derivative_by_runs.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A stone on a rope, thrown from where it is taut.
const std::string stone = R"deck(gravity = [0, 0, -9.81]
[parameters]
L = 1
v = 1
m = 2
d = 0.3
[body.stone]
mass = "m"
inertia = [1e-2, 2e-2, 1e-2]
at = [0, 0, "-L"]
velocity = ["v", 0, 0]
[joint.rope]
type = "distance"
between = ["ground", "stone"]
at_a = [0, 0, 0]
SLACK
[[load]]
at = "stone"
force = ["-d", 0.2, 0]
[[history]]
name = "stone"
at = "stone"
quantities = ["position", "velocity"]
[[history]]
name = "rope"
at = "rope"
quantities = ["force"]
[analysis]
kind = "dynamic"
end_time = 0.6
time_step = 0.01
integrator = "SCHEME"
newton = { tolerance = 1e-12 }
)deck";

// A beam, which a load bends until a rope is taut, and turns at a hinge until that is at its stop.
const std::string beam = R"deck([parameters]
EI = 6
L = 1.03
stop = 0.2
F = 0.9
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 3
[joint.hinge]
type = "hinge"
between = ["ground", "r.start"]
axis = [0, 0, 1]
limits = { upper = "stop", lower = -0.2 }
spring = { stiffness = 1 }
[joint.rope]
type = "distance"
between = ["ground", "r.end"]
at_a = [1, 0, 1]
length = "L"
slack = true
[[load]]
at = "r.end"
force = [0, "F", "-F"]
[[history]]
name = "tip"
at = "r.end"
quantities = ["position"]
)deck";

const std::string statics = "[analysis]\nkind = \"static\"\nsteps = 6\nnewton = { tolerance = 1e-12 }\n";

std::string stone_of(const std::string& scheme, const std::string& slack = "slack = true") {
    return replaced(replaced(stone, "SLACK", slack), "SCHEME", scheme);
}

}  // namespace

TEST_CASE("derivatives of a taut rope are those of a bar", "[sensitivity][stops]") {
    const std::string scheme = GENERATE("newmark-simplified", "generalized-alpha", "sdirk-4", "radau-5");
    const Deck rope = Deck::from_text(stone_of(scheme)), bar = Deck::from_text(stone_of(scheme, ""));
    for (const auto& [name, value] : {std::pair{"L", 1.0}, {"v", 1.0}, {"m", 2.0}, {"d", 0.3}}) {
        CAPTURE(scheme, name);
        require_close(carry_along(rope, name, "stone", "position"),
                      take_differences(rope, name, value, "stone", "position"),
                      1e-6);
        require_close(
            carry_along(rope, name, "stone", "velocity"), carry_along(bar, name, "stone", "velocity"), 1e-4);
    }
}

TEST_CASE("there is no derivative from a step on in which a rope becomes taut", "[sensitivity][stops]") {
    const Deck deck = Deck::from_text(
        replaced(stone_of("newmark-simplified"), "slack = true", "slack = true\nlength = 1.1"));
    std::vector<VariedNumber> variations;
    variations.push_back(vary(deck, "v"));
    Simulation run(deck.build(), {.sensitivities = std::move(variations)});
    const auto derivative = [&] { return run["stone"].derivative("v")["position"].numbers(); };
    double last = 0.0;
    while (run["rope"]["force"].numbers() == std::vector<double>{0.0, 0.0, 0.0}) {
        last = derivative()[0];
        REQUIRE(run.step());
    }
    CHECK(last > 0.05);
    CHECK_THROWS_WITH(
        derivative(),
        Contains("does not exist from t = ") && Contains("where a joint becomes taut or slack"));
}

TEST_CASE("derivatives of equilibria go on where ropes become taut and stops are met",
          "[sensitivity][stops]") {
    // In a single step all changes are in the last one.
    const std::string steps = GENERATE(as<std::string>{}, "steps = 1", "steps = 6");
    const Deck deck = Deck::from_text(beam + replaced(statics, "steps = 6", steps));
    Simulation run(deck.build());
    run.run();
    for (const auto& [name, value] : {std::pair{"EI", 6.0}, {"L", 1.03}, {"stop", 0.2}, {"F", 0.9}}) {
        CAPTURE(name);
        const std::vector<double> carried = carry_along(deck, name, "tip", "position");
        require_close(carried, take_differences(deck, name, value, "tip", "position"), 1e-6);
        for (std::size_t i = 0; i < 3; ++i) {
            std::vector<double> weights(3, 0.0);
            weights[i] = 1.0;
            std::vector<VariedNumber> variations;
            variations.push_back(vary(deck, name));
            CHECK(run.find_gradient({{0, 0, weights}}, variations).by_numbers[0] ==
                  Approx(carried[i]).epsilon(1e-8).margin(1e-9));
        }
    }
}

TEST_CASE("derivatives of ropes and stops are not there by multipliers through a motion",
          "[sensitivity][stops]") {
    const Deck deck = Deck::from_text(stone_of("newmark-simplified"));
    Simulation run(deck.build());
    run.run();
    std::vector<VariedNumber> variations;
    variations.push_back(vary(deck, "v"));
    CHECK_THROWS_WITH(run.find_gradient({{0, 0, {1.0, 0.0, 0.0}}}, variations),
                      Contains("joints that can be slack, and stops, cannot be gone back through"));
}

}  // namespace gxrod::test
