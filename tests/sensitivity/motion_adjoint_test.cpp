// Derivatives of motions by multipliers against those that are carried along.
#include "sensitivity/motion_adjoint.hpp"
#include "assembly/system_values.hpp"

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

// Of forces and strains within an element.
const MotionAdjoint::Quantity of_section{
    {1, 2}, [](const System& system, const State& ended, int, int) {
        const PointValues point =
            SystemValues(system).compute_point_values(ended, ended.trial_time, {{0, 1, 0.6}})[0];
        return weights.dot(point.force + 3.0 * point.moment) + weights.dot(point.strain + point.curvature);
    }};

// What both give of a deck's number: the sum over all states, or of the last one.
void compare(const std::string& deck,
             const std::vector<std::string>& names,
             double tolerance,
             bool all,
             const MotionAdjoint::Quantity& quantity = of_tip,
             double step = 1e-3) {
    const Problem base = read(deck);
    SteppedRun run(request_of(base));
    std::vector<Variation> varied;
    std::vector<VariedModels> models;
    for (const std::string& name : names) varied.emplace_back(deck, name, step);
    for (const Variation& one : varied) models.push_back(one.models());
    REQUIRE(run.start());
    Sensitivities sensitivities(run.analysis(), base.analysis(), models);
    MotionAdjoint adjoint(run.analysis(), base.analysis(), models);
    sensitivities.start();
    std::vector<double> forward(names.size(), 0.0), backward;
    const auto add = [&] {
        for (std::size_t i = 0; i < names.size(); ++i)
            forward[i] +=
                value_of(deck, names[i]) *
                sensitivities.by(i).differentiate([&](const System& system, const State& at, std::size_t) {
                    return std::vector{quantity.value(system, at, -1, -1)};
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
        adjoint.step_back(stages[i], states[i], states[i + 1], all || i + 1 == count ? &quantity : nullptr);
    adjoint.end(all ? &quantity : nullptr);
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

// With a law that has a number Y.
std::string with_law(const std::string& deck, const std::string& law) {
    return replaced(replaced(deck, "angle = 0.3\n", "angle = 0.3\nY = 0.3\n"),
                    "[rod.r]",
                    "law = { " + law + " }\n[rod.r]");
}

const std::vector<std::string> all_laws{
    "viscoelastic = { prony = [[\"Y\", 0.1], [0.2, 2]] }",
    "plastic = { yield = { Mz = \"Y\" }, kinematic = 0.3 }",
    "plastic = { yield = { My = 0.4, Mz = \"Y\", T = 0.2 }, isotropic = [[0, 1], [2, 1.5]] }",
    "layers = [{ on = \"bending\", stiffness = 3, limit = \"Y\" }, { on = \"torsion\", stiffness = 2, limit "
    "= 0.1 "
    "}]"};

std::string as_simo(const std::string& deck, int order = 1) {
    return replaced(deck,
                    "elements = 4",
                    order == 1
                        ? "elements = 4\nelement = \"simo\""
                        : fmt::format("elements = {}\norder = {}\nelement = \"simo\"", 4 / order, order));
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

TEST_CASE("derivatives by multipliers of sections that remember", "[sensitivity]") {
    const std::vector<std::string> names{"EI", "rho", "F", "L", "c", "angle", "Y"};
    constexpr double fine = 2.5e-4;  // what is carried along is curved where sections yield
    for (const std::string& law : all_laws) {
        CAPTURE(law);
        const std::string deck = with_law(make_carried(), law);
        for (const char* scheme : {"newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha"}) {
            CAPTURE(scheme);
            compare(with_integrator(deck, scheme), names, 1e-10, true, of_tip, fine);
        }
        compare(as_static(deck), {"EI", "F", "L", "angle", "Y"}, 1e-9, true, of_tip, 6e-5);
        compare(deck, names, 1e-9, true, of_section, fine);
        compare(with_law(swinging_rod + hinged_end, law), names, 3e-9, true, of_tip, fine);
    }
}

TEST_CASE("derivatives by multipliers of elements that measure from the last step", "[sensitivity]") {
    for (const int order : {1, 2}) {
        CAPTURE(order);
        const std::string deck = as_simo(make_carried(), order);
        for (const char* scheme : {"newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha"}) {
            CAPTURE(scheme);
            compare(with_integrator(deck, scheme), all_names, 1e-10, true);
        }
        compare(as_static(deck), {"EI", "F", "L", "angle"}, 1e-10, true);
    }
    compare(as_simo(make_swung()), {"EI", "L", "A"}, 1e-10, true);
    compare(as_simo(make_carried()), all_names, 1e-9, true, of_section);
    compare(as_simo(swinging_rod + hinged_end), all_names, 1e-9, true);
    const std::string yielding = with_law(as_simo(make_carried()), all_laws[2]);
    compare(yielding, {"EI", "L", "Y"}, 1e-10, true, of_tip, 2.5e-4);
    compare(yielding, {"EI", "L", "Y"}, 1e-9, true, of_section, 2.5e-4);
}

TEST_CASE("derivatives by multipliers where joints rub", "[sensitivity]") {
    const std::string deck =
        replaced(replaced(swinging_rod + hinged_end, "angle = 0.3\n", "angle = 0.3\nY = 0.1\n"),
                 "spring = {",
                 "friction = { moment = \"Y\" }\nspring = {");
    compare(deck, {"EI", "rho", "F", "L", "Y"}, 1e-8, true);
    compare(as_static(deck), {"EI", "F", "L", "Y"}, 1e-8, true);
}

TEST_CASE("derivatives by multipliers where tendons rub", "[sensitivity]") {
    const std::string deck =
        replaced(replaced(make_carried(), "angle = 0.3\n", "angle = 0.3\nY = 0.2\n"),
                 "[[support]]",
                 "[tendon.t]\non = \"r\"\noffset = [0, 0.05]\ntension = \"9*t\"\nfriction = \"Y\"\n"
                 "stiffness = 200\n[[support]]");
    const std::string short_one = replaced(deck, "end_time = 0.6", "end_time = 0.1");
    compare(short_one, {"EI", "rho", "F", "L", "Y"}, 1e-8, true, of_tip, 2e-4);
    // It sticks.
    compare(replaced(short_one, "9*t", "1"), {"EI", "rho", "F"}, 1e-8, true, of_tip, 2e-4);
    compare(as_static(deck), {"EI", "F", "L", "Y"}, 1e-8, true);
}

TEST_CASE("motions that cannot be gone back through are refused", "[sensitivity]") {
    const auto make = [](const std::string& deck) {
        const Problem problem = read(deck);
        SteppedRun run(request_of(problem));
        REQUIRE(run.start());
        MotionAdjoint(run.analysis(), problem.analysis(), {});
    };
    CHECK_THROWS_WITH(make(with_integrator(make_carried(), "sdirk-4")), Contains("other schemes than"));
    CHECK_THROWS_WITH(make(replaced(swinging_rod + hinged_end,
                                    "spring = {",
                                    "friction = { coefficient = 0.2, radius = 0.1 }\nspring = {")),
                      Contains("friction that grows with a joint's force"));
}

}  // namespace gxrod::test
