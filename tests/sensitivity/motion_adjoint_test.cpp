// Derivatives of motions by multipliers against those that are carried along.
#include "sensitivity/motion_adjoint.hpp"

#include "sensitivity/swing.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

constexpr int tip = 4;
const Vec3 weights(0.3, -1.1, 0.7);

// Of all that a motion has, where the step ends.
double weigh(const State& state) {
    const NodeMotion& node = state.trial[tip];
    return weights.dot(node.r) + weights.dot(node.Lambda * Vec3(1.0, 2.0, 3.0)) + 0.1 * weights.dot(node.v) +
           0.03 * weights.dot(node.omega) * node.r.x() + 1e-3 * weights.dot(node.a) +
           1e-4 * weights.dot(node.alpha);
}

const MotionAdjoint::Quantity of_tip{
    {tip}, [](const System&, const State& ended, int, int) { return weigh(ended); }};

// What both give of a deck's number: the sum over all states, or of the last one.
void compare(const std::string& deck, const std::vector<std::string>& names, double tolerance, bool all) {
    const Problem base = read(deck);
    SteppedRun run(request_of(base));
    std::vector<Variation> varied;
    std::vector<VariedModels> models;
    for (const std::string& name : names) varied.emplace_back(deck, name, 1e-3);
    for (const Variation& one : varied) models.push_back(one.models());
    REQUIRE(run.start());
    Sensitivities sensitivities(run.analysis(), base.analysis(), models);
    MotionAdjoint adjoint(run.analysis(), base.analysis(), models);
    sensitivities.start();
    std::vector<double> forward(names.size(), 0.0), backward;
    const auto add = [&] {
        for (std::size_t i = 0; i < names.size(); ++i)
            forward[i] += value_of(deck, names[i]) *
                          sensitivities.by(i).differentiate([](const System&, const State& at, std::size_t) {
                              return std::vector{weigh(at)};
                          })[0];
    };
    std::vector<State> states{run.analysis().state()};
    std::vector<Stage> stages;
    if (all) add();
    while (!run.has_ended()) {
        sensitivities.note_before();
        REQUIRE(run.step());
        sensitivities.advance();
        states.push_back(run.analysis().state());
        stages.push_back(run.analysis().last_stage());
        if (all || run.has_ended()) add();
    }
    const std::size_t count = stages.size();
    for (std::size_t i = count; i-- > 0;)
        adjoint.step_back(stages[i], states[i], states[i + 1], all || i + 1 == count ? &of_tip : nullptr);
    adjoint.end(all ? &of_tip : nullptr);
    double largest = 0.0;
    for (const double one : forward) largest = std::max(largest, std::abs(one));
    for (std::size_t i = 0; i < names.size(); ++i) {
        INFO(names[i] << ": " << forward[i]);
        const double distance = std::abs(value_of(deck, names[i]) * adjoint.by_numbers()[i] - forward[i]);
        CHECK(1e12 * distance / largest < 1e12 * tolerance);
    }
}

const std::vector<std::string> all_names{"EI", "rho", "F", "L", "c", "angle"};

// The support swings by an amplitude that is a parameter, and turns.
std::string make_swung() {
    return replaced(
        replaced(make_carried(), "angle = 0.3\n", "angle = 0.3\nA = 0.2\n"),
        "at = \"r.start\"\nfix = \"all\"\n",
        "at = \"r.start\"\nfix = [\"x\", \"y\"]\nmove = { z = \"A*sin(5*t)^2\", rx = \"A*t^2\", ry = "
        "\"0.3*t\", rz = \"0\" }\n");
}

}  // namespace

TEST_CASE("derivatives of motions by multipliers are those that are carried along", "[sensitivity]") {
    for (const char* scheme : {"newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha"}) {
        CAPTURE(scheme);
        compare(with_integrator(make_carried(), scheme), all_names, 1e-10, false);
        compare(with_integrator(make_carried(), scheme), all_names, 1e-10, true);
    }
}

TEST_CASE("derivatives by multipliers where a support moves", "[sensitivity]") {
    std::vector<std::string> names = all_names;
    names.push_back("A");
    compare(make_swung(), names, 1e-10, true);
}

TEST_CASE("derivatives by multipliers where a support is a hinge", "[sensitivity]") {
    const std::string deck = replaced(make_carried(),
                                      "at = \"r.start\"\nfix = \"all\"\n",
                                      "at = \"r.start\"\nfix = [\"x\", \"y\", \"z\", \"rx\", \"rz\"]\n");
    compare(deck, all_names, 1e-10, true);
}

TEST_CASE("derivatives by multipliers of all load steps", "[sensitivity]") {
    compare(as_static(make_carried()), {"EI", "F", "L", "angle"}, 1e-12, true);
    compare(as_static(swinging_rod + hinged_end), {"EI", "F", "L", "angle"}, 1e-12, true);
}

TEST_CASE("derivatives of mechanisms by multipliers are those that are carried along", "[sensitivity]") {
    for (const char* scheme : {"newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha"}) {
        CAPTURE(scheme);
        compare(with_integrator(swinging_rod + hinged_end, scheme), all_names, 1e-9, true);
    }
}

TEST_CASE("motions that cannot be gone back through are refused", "[sensitivity]") {
    const auto make = [](const std::string& deck) {
        const Problem problem = read(deck);
        SteppedRun run(request_of(problem));
        REQUIRE(run.start());
        MotionAdjoint(run.analysis(), problem.analysis(), {});
    };
    CHECK_THROWS_WITH(make(with_integrator(make_carried(), "sdirk-4")), Contains("other schemes than"));
    CHECK_THROWS_WITH(make(replaced(make_carried(), "elements = 4", "elements = 4\nelement = \"simo\"")),
                      Contains("depend on earlier steps"));
}

}  // namespace gxrod::test
