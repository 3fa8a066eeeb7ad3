// Derivatives by multipliers against those that are carried along.
#include "sensitivity/equilibrium_adjoint.hpp"

#include "sensitivity/sensitivities.hpp"
#include "sensitivity/swing.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

constexpr int tip = 4;
const Vec3 weights(0.3, -1.1, 0.7);

double weigh(const State& state) {
    const NodeMotion& node = state.trial[tip];
    return weights.dot(node.r) + weights.dot(node.Lambda * Vec3(1.0, 2.0, 3.0));
}

// What both give of a deck's number.
void compare(const std::string& deck, const std::vector<std::string>& names, double tolerance) {
    const Problem base = read(deck);
    SteppedRun simulation(request_of(base));
    std::vector<Variation> varied;
    std::vector<VariedModels> models;
    // Round-off of the quantity over the step is what is left; the error of the step is common to both.
    for (const std::string& name : names) varied.emplace_back(deck, name, 1e-3);
    for (const Variation& one : varied) models.push_back(one.models());
    Sensitivities sensitivities(simulation.analysis(), base.analysis(), models);
    REQUIRE(simulation.start());
    sensitivities.start();
    while (!simulation.has_ended()) {
        sensitivities.note_before();
        REQUIRE(simulation.step());
        sensitivities.advance();
    }
    const State& state = simulation.analysis().state();
    const auto quantity = [](const System&, const State& at, int) { return weigh(at); };
    const EquilibriumAdjoint adjoint(
        simulation.analysis().system(), state, state.time, LinearSolverKind::automatic, {tip}, quantity);
    // By the relative change of each number.
    std::vector<double> forward, backward;
    double largest = 0.0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double p = value_of(deck, names[i]);
        forward.push_back(p *
                          sensitivities.by(i).differentiate([](const System&, const State& at, std::size_t) {
                              return std::vector{weigh(at)};
                          })[0]);
        backward.push_back(p * adjoint.differentiate(models[i], quantity));
        largest = std::max(largest, std::abs(forward.back()));
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        INFO(names[i]);
        CHECK(1e12 * std::abs(backward[i] - forward[i]) / largest < 1e12 * tolerance);
    }
}

}  // namespace

TEST_CASE("derivatives by multipliers are those that are carried along", "[sensitivity]") {
    // A following force and moment make the tangent unsymmetric.
    compare(as_static(make_carried()), {"EI", "F", "L", "angle"}, 1e-12);
}

TEST_CASE("derivatives by multipliers are those that are carried along, of mechanisms too", "[sensitivity]") {
    compare(as_static(swinging_rod + hinged_end), {"EI", "F", "L", "angle"}, 1e-12);
}

TEST_CASE("what depends on how it was reached has no derivatives by multipliers", "[sensitivity]") {
    const Problem base =
        read(replaced(as_static(make_carried()), "elements = 4", "elements = 4\nelement = \"simo\""));
    const System system(base.model);
    const auto make = [&] {
        return EquilibriumAdjoint(system,
                                  system.initial_state(),
                                  1.0,
                                  LinearSolverKind::automatic,
                                  {tip},
                                  [](const System&, const State& state, int) { return weigh(state); });
    };
    CHECK_THROWS_WITH(make(), Contains("depends on how it was reached"));
}

TEST_CASE("what touches has no derivatives by multipliers", "[sensitivity]") {
    const Problem base = read(
        replaced(
            replaced(static_rod_deck, "simo", "objective"), "[section.s]\n", "[section.s]\nradius = 0.01\n") +
        "[contact]\nself = false\n[obstacle.o]\nplane = { point = [0, 0, -99], normal = [0, 0, 1] }\n");
    const System system(base.model);
    const auto make = [&] {
        return EquilibriumAdjoint(system,
                                  system.initial_state(),
                                  1.0,
                                  LinearSolverKind::automatic,
                                  {1},
                                  [](const System&, const State&, int) { return 0.0; });
    };
    CHECK_THROWS_WITH(make(), Contains("no derivatives of contact by multipliers yet"));
}

TEST_CASE("tendons that rub have no derivatives by multipliers", "[sensitivity]") {
    const Problem base = read(replaced(static_rod_deck, "simo", "objective") +
                              "[tendon.t]\non = \"r\"\noffset = [0, 1]\ntension = 1\nfriction = 0.1\n");
    const System system(base.model);
    const auto make = [&] {
        return EquilibriumAdjoint(system,
                                  system.initial_state(),
                                  1.0,
                                  LinearSolverKind::automatic,
                                  {1},
                                  [](const System&, const State&, int) { return 0.0; });
    };
    CHECK_THROWS_WITH(make(), Contains("friction depends on how it was reached"));
}

}  // namespace gxrod::test
