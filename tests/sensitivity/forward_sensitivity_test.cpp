// Derivatives that are carried along against differences of whole runs, extrapolated.
#include "assembly/system_measures.hpp"
#include "assembly/system_values.hpp"
#include "sensitivity/sensitivities.hpp"

#include <algorithm>
#include <array>

#include "rotation/rotation_map.hpp"
#include "sensitivity/swing.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

VariedModels vary(const Problem& one, const Problem& other) {
    return {{one.model, other.model, 1.0}, {one.model, other.model, 2.0}};
}

constexpr int tip = 4;
constexpr Eigen::Index accelerations = 9;  // in list_end

// What a run ends with: r, v, ω and a of the tip.
Eigen::VectorXd list_end(const State& state, bool has_rates) {
    const NodeMotion& node = state.previous[tip];
    Eigen::VectorXd end(has_rates ? 12 : 3);
    end.head<3>() = node.r;
    if (has_rates) end.tail<9>() << node.v, node.omega, node.a;
    return end;
}

Eigen::VectorXd run_with(const std::string& deck, const std::string& name, double value, bool has_rates) {
    const Problem problem = read(set(deck, name, value));
    SteppedRun simulation(request_of(problem));
    while (simulation.step()) {
    }
    REQUIRE(simulation.summary().reason.empty());
    return list_end(simulation.analysis().state(), has_rates);
}

// Steps relative to a number: of differences of whole runs, and of the models next to the analysed one.
struct Steps {
    double whole_runs = 1e-2, models = 5e-4;
};

Eigen::VectorXd extrapolate(const std::string& deck,
                            const std::string& name,
                            bool has_rates,
                            const Steps& steps) {
    const double p = value_of(deck, name);
    const auto difference = [&](double h) -> Eigen::VectorXd {
        return (run_with(deck, name, p + h, has_rates) - run_with(deck, name, p - h, has_rates)) / (2.0 * h);
    };
    const double h = steps.whole_runs * std::abs(p);
    const Eigen::VectorXd coarse = difference(h), middle = difference(0.5 * h), fine = difference(0.25 * h);
    return (64.0 * fine - 20.0 * middle + coarse) / 45.0;
}

Eigen::VectorXd carry_along(const std::string& deck,
                            const std::string& name,
                            bool has_rates,
                            const Steps& steps) {
    const Problem base = read(deck);
    const Variation varied(deck, name, steps.models);
    SteppedRun simulation(request_of(base));
    REQUIRE(simulation.start());
    Sensitivities sensitivities(simulation.analysis(), base.analysis(), {varied.models()});
    sensitivities.start();
    while (!simulation.has_ended()) {
        sensitivities.note_before();
        REQUIRE(simulation.step());
        sensitivities.advance();
    }
    CHECK(sensitivities.by(0).kink().empty());
    const StateDirection::OfNode& node = sensitivities.by(0).direction().nodes[tip];
    Eigen::VectorXd derivative(has_rates ? 12 : 3);
    derivative.head<3>() = node.r;
    if (has_rates) derivative.tail<9>() << node.v, node.omega, node.a;
    return derivative;
}

void check_all(const std::string& deck,
               const std::vector<std::string>& names,
               bool has_rates,
               double tolerance,
               const Steps& steps = {}) {
    for (const std::string& name : names) {
        INFO(name);
        const Eigen::VectorXd expected = extrapolate(deck, name, has_rates, steps);
        const Eigen::VectorXd derivative = carry_along(deck, name, has_rates, steps);
        for (Eigen::Index i = 0; i < expected.size(); i += 3) {
            CAPTURE(i);
            // Round-off of accelerations is that of positions over Δt².
            const double allowed = (i == accelerations ? 10.0 : 1.0) * tolerance;
            CHECK((derivative.segment<3>(i) - expected.segment<3>(i)).norm() <
                  allowed * expected.segment<3>(i).norm());
        }
    }
}

// Whole runs by an explicit scheme and of creep have more round-off.
constexpr double with_round_off = 1e-7;
// Newton's tolerance shows in differences of whole runs by schemes of several stages, the more the smaller
// their steps.
const Steps of_stages{.whole_runs = 2e-2};
const std::vector<std::string> all_names{"EI", "rho", "F", "L", "c", "angle"};

}  // namespace

TEST_CASE("derivatives of motions are those of whole runs", "[sensitivity]") {
    const std::string scheme = GENERATE("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha");
    INFO(scheme);
    check_all(with_integrator(make_carried(), scheme), all_names, true, 1e-8);
}

TEST_CASE("derivatives of motions by schemes of several stages are those of whole runs", "[sensitivity]") {
    const std::string scheme = GENERATE("sdirk-4", "radau-5", "gauss-4");
    INFO(scheme);
    check_all(with_integrator(make_carried(), scheme), all_names, true, 1e-8, of_stages);
}

TEST_CASE("derivatives of motions by an explicit scheme are those of whole runs", "[sensitivity]") {
    check_all(as_explicit(make_carried()), {"EI", "rho", "L"}, true, with_round_off);
}

TEST_CASE("derivatives of creep are those of whole runs", "[sensitivity]") {
    const std::string deck = replaced(make_carried(), "kind = \"dynamic\"", "kind = \"quasi-static\"");
    check_all(deck, {"EI", "F", "L", "c"}, false, with_round_off);
}

TEST_CASE("derivatives of motions of mechanisms are those of whole runs", "[sensitivity]") {
    const std::string scheme = GENERATE("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha");
    INFO(scheme);
    check_all(with_integrator(swinging_rod + hinged_end, scheme), {"EI", "rho", "L", "angle"}, true, 1e-8);
}

TEST_CASE("derivatives of mechanisms by schemes of several stages are those of whole runs", "[sensitivity]") {
    const std::string scheme = GENERATE("sdirk-4", "radau-5", "gauss-4");
    INFO(scheme);
    check_all(with_integrator(swinging_rod + hinged_end, scheme), {"EI", "rho", "L", "angle"}, true, 1e-8);
}

TEST_CASE("derivatives of mechanisms by an explicit scheme are those of whole runs", "[sensitivity]") {
    check_all(as_explicit(swinging_rod + hinged_end), {"EI", "rho", "L"}, true, with_round_off);
}

TEST_CASE("derivatives of motions of elements with memory and of higher order", "[sensitivity]") {
    check_all(replaced(make_carried(), "elements = 4", "elements = 4\nelement = \"simo\""),
              {"EI", "L"},
              true,
              1e-8);
    check_all(replaced(make_carried(), "elements = 4", "elements = 2\norder = 2"), {"EI", "L"}, true, 1e-8);
}

TEST_CASE("derivatives of motions of sections that remember", "[sensitivity]") {
    const auto with_law = [](const std::string& law) {
        return replaced(make_carried(), "[rod.r]", "law = { " + law + " }\n[rod.r]");
    };
    check_all(with_law("viscoelastic = { prony = [[0.5, 0.1], [0.2, 2]] }"), {"EI", "rho", "L"}, true, 1e-8);
    check_all(with_law("plastic = { yield = { Mz = 0.3 }, kinematic = 0.3 }"), {"EI", "F"}, true, 1e-8);
}

TEST_CASE("derivatives of sections that remember by schemes of several stages", "[sensitivity]") {
    const std::string scheme = GENERATE("sdirk-4", "radau-5", "gauss-4");
    INFO(scheme);
    const std::string law = "law = { viscoelastic = { prony = [[0.5, 0.1], [0.2, 2]] } }\n[rod.r]";
    check_all(with_integrator(replaced(make_carried(), "[rod.r]", law), scheme),
              {"EI", "rho", "L"},
              true,
              1e-8,
              of_stages);
    check_all(
        with_integrator(replaced(make_carried(), "elements = 4", "elements = 4\nelement = \"simo\""), scheme),
        {"EI", "L"},
        true,
        1e-8,
        of_stages);
}

TEST_CASE("derivatives of sections that yield by stages that are found together", "[sensitivity]") {
    const std::string scheme = GENERATE("radau-5", "gauss-4");
    INFO(scheme);
    const auto with_law = [&](const std::string& law) {
        return with_integrator(replaced(make_carried(), "[rod.r]", "law = { " + law + " }\n[rod.r]"), scheme);
    };
    const Steps within_pieces{.whole_runs = 1e-3};
    check_all(with_law("plastic = { yield = { Mz = 0.3 }, kinematic = 0.3 }"),
              {"EI", "F"},
              true,
              1e-7,
              within_pieces);
    check_all(with_law("layers = [{ on = \"bending\", stiffness = 3, limit = 0.3 }]"),
              {"EI", "F"},
              true,
              1e-7,
              within_pieces);
}

TEST_CASE("derivatives of joints that rub by stages that are found together", "[sensitivity]") {
    const std::string scheme = GENERATE("radau-5", "gauss-4");
    INFO(scheme);
    const std::string deck =
        replaced(swinging_rod + hinged_end, "spring = {", "friction = { moment = 0.1 }\nspring = {");
    check_all(
        replaced(with_integrator(deck, scheme), "end_time = 0.6", "end_time = 0.1"), {"EI", "F"}, true, 1e-5);
}

namespace {

// A cantilever that falls onto a floor; with `hinge` a ball hangs at its end.
std::string make_touching(const std::string& analysis, bool has_hinge = false) {
    const std::string ball = has_hinge ? R"([body.b]
mass = 0.5
inertia = [0.01, 0.02, 0.02]
at = ["L", 0, 0]
sphere = { radius = 0.12 }
[joint.pin]
type = "hinge"
between = ["r.end", "b"]
axis = [0, 1, 0]
spring = { stiffness = 3 }
)"
                                       : "";
    return R"(gravity = [0, 0, -9.81]
[parameters]
EI = 6
rho = 1.2
F = 3
L = 2
floor = -0.3
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }
inertia = { rhoA = "rho", rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
damping = { kelvin_voigt = 0.02, mass_proportional = 0.1 }
radius = 0.1
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = ["L", 0, 0] }
elements = 4
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, "F*t", 0]
[obstacle.floor]
plane = { point = [0, 0, "floor"], normal = [0, 0, 1] }
[contact]
)" + ball + "[analysis]\nnewton = { tolerance = 1e-12 }\n" +
           analysis;
}

// Gaps bound both steps: of runs, which must not open others, and of models, if they move the floor.
constexpr Steps next_to_floor{.whole_runs = 1e-4};
constexpr Steps of_floor{.whole_runs = 3e-5, .models = 7e-7};

}  // namespace

TEST_CASE("derivatives of what lies on an obstacle are those of whole runs", "[sensitivity]") {
    const bool has_hinge = GENERATE(false, true);
    CAPTURE(has_hinge);
    const std::string deck = make_touching("kind = \"static\"\nsteps = 20\n", has_hinge);
    check_all(deck, {"EI", "F", "L"}, false, 1e-8, next_to_floor);
    check_all(deck, {"floor"}, false, 1e-8, of_floor);
}

TEST_CASE("derivatives of impacts are those of whole runs", "[sensitivity]") {
    const bool has_hinge = GENERATE(false, true);
    CAPTURE(has_hinge);
    const std::string deck = make_touching(
        fmt::format("kind = \"dynamic\"\ntime_step = 0.01\nend_time = {}\n", has_hinge ? 0.36 : 0.6),
        has_hinge);
    check_all(deck, {"EI", "rho", "L"}, true, 1e-7, next_to_floor);
    check_all(deck, {"floor"}, true, 1e-7, of_floor);
}

TEST_CASE("derivatives of what rubs on an obstacle are those of whole runs", "[sensitivity]") {
    const std::string deck =
        replaced(make_touching("kind = \"static\"\nsteps = 20\n"), "[contact]", "friction = 0.2\n[contact]");
    check_all(deck, {"EI", "F"}, false, 1e-6, next_to_floor);
}

TEST_CASE("friction of rods on each other has no derivatives", "[sensitivity]") {
    const Problem base = read(replaced(
        make_touching("kind = \"static\"\n"), "[contact]", "[contact]\nself = true\nfriction = 0.2"));
    SteppedRun simulation(request_of(base));
    REQUIRE(simulation.start());
    CHECK_THROWS_WITH(Sensitivities(simulation.analysis(), base.analysis(), {vary(base, base)}),
                      Contains("friction between rods and bodies that touch each other"));
}

TEST_CASE("friction that falls with the speed has no derivatives in motions", "[sensitivity]") {
    const Problem base =
        read(replaced(make_touching("kind = \"dynamic\"\nend_time = 0.1\ntime_step = 0.01\n"),
                      "[contact]",
                      "friction = { static = 0.2, kinetic = 0.1, stribeck_speed = 0.1 }\n[contact]"));
    SteppedRun simulation(request_of(base));
    REQUIRE(simulation.start());
    CHECK_THROWS_WITH(Sensitivities(simulation.analysis(), base.analysis(), {vary(base, base)}),
                      Contains("no derivatives of friction that falls with the speed"));
}

TEST_CASE("derivatives of equilibria of mechanisms are those of whole runs", "[sensitivity]") {
    check_all(as_static(swinging_rod + hinged_end), {"EI", "F", "L", "angle"}, false, 1e-8);
}

TEST_CASE("derivatives of equilibria are those of whole runs", "[sensitivity]") {
    check_all(as_static(make_carried()), {"EI", "F", "L", "angle"}, false, 1e-8);
    check_all(replaced(as_static(make_carried()), "elements = 4", "elements = 4\nelement = \"simo\""),
              {"EI", "L"},
              false,
              1e-8);
}

TEST_CASE("derivatives by numbers that move a support are those of whole runs", "[sensitivity]") {
    const std::string deck = replaced(make_carried(),
                                      "from = [0, 0, 0], to = [\"L*cos(angle)\"",
                                      "from = [\"0.3*L\", 0, 0], to = [\"0.3*L + L*cos(angle)\"");
    check_all(as_static(deck), {"L"}, false, 1e-8);
    check_all(deck, {"L"}, true, 1e-8);
    for (const char* scheme : {"sdirk-4", "radau-5", "gauss-4"}) {
        INFO(scheme);
        check_all(with_integrator(deck, scheme), {"L"}, true, 1e-8);
    }
    check_all(as_explicit(deck), {"L"}, true, with_round_off);
}

TEST_CASE("what cannot be differentiated is refused", "[sensitivity]") {
    const Problem base = read(make_carried());
    SteppedRun simulation(request_of(base));
    REQUIRE(simulation.start());
    const Problem other = read(replaced(make_carried(), "elements = 4", "elements = 5"));
    CHECK_THROWS_WITH(Sensitivities(simulation.analysis(), base.analysis(), {vary(other, base)}),
                      Contains("which nodes and elements"));
    const Problem held = read(make_carried() + "[[support]]\nat = \"r.end\"\nfix = \"z\"\n");
    CHECK_THROWS_WITH(Sensitivities(simulation.analysis(), base.analysis(), {vary(held, base)}),
                      Contains("which motions are held"));
}

TEST_CASE("functions of a state are differentiated along it", "[sensitivity]") {
    const std::string deck = as_static(make_carried());
    const double p = value_of(deck, "EI");
    const Problem base = read(deck);
    const Variation varied(deck, "EI");
    SteppedRun simulation(request_of(base));
    REQUIRE(simulation.start());
    Sensitivities sensitivities(simulation.analysis(), base.analysis(), {varied.models()});
    sensitivities.start();
    while (!simulation.has_ended()) {
        sensitivities.note_before();
        REQUIRE(simulation.step());
        sensitivities.advance();
    }
    const auto energy = [](const System& system, const State& state) {
        return SystemMeasures(system).compute_balance(state, 1.0).strain_energy;
    };
    const std::vector<double> derivative =
        sensitivities.by(0).differentiate([&](const System& system, const State& state, std::size_t) {
            return std::vector{energy(system, state)};
        });
    const auto run = [&](double value) {
        const Problem problem = read(set(deck, "EI", value));
        SteppedRun other(request_of(problem));
        while (other.step()) {
        }
        return energy(other.analysis().system(), other.analysis().state());
    };
    const double k = 2e-3 * p;
    const auto difference = [&](double step) { return (run(p + step) - run(p - step)) / (2.0 * step); };
    CHECK(derivative[0] == Approx((4.0 * difference(0.5 * k) - difference(k)) / 3.0).epsilon(1e-8));
}

namespace {

// Section values at places of the rod, and what the support exerts.
std::vector<double> list_sections(const System& system, const State& state) {
    Residual residual;
    system.compute_residual(state, state.trial_time, residual);
    const Vec6 reaction = SystemMeasures(system).compute_reactions(residual)[0];
    std::vector<double> values(reaction.begin(), reaction.end());
    const std::vector<RodPlace> places{{0, 0, -0.4}, {0, 1, 0.6}, {0, 3, 1.0}};
    for (const PointValues& point :
         SystemValues(system).compute_point_values(state, state.trial_time, places)) {
        for (const Vec3& value : {point.force, point.moment, point.strain, point.curvature})
            values.insert(values.end(), value.begin(), value.end());
    }
    return values;
}

// Of a whole run: the end of its last step, as it was before it was accepted.
std::vector<double> end_sections(const std::string& deck, const std::string& name, double value) {
    const Problem problem = read(set(deck, name, value));
    SteppedRun simulation(request_of(problem));
    REQUIRE(simulation.start());
    State before;
    while (!simulation.has_ended()) {
        before = simulation.analysis().state();
        REQUIRE(simulation.step());
    }
    const State& after = simulation.analysis().state();
    undo_trial(before);
    before.trial = after.previous;
    before.trial_time = after.time;
    for (std::size_t i = 0; i < before.trial.size(); ++i)
        before.trial[i].theta = log(before.trial[i].Lambda * before.previous[i].Lambda.conjugate());
    return list_sections(simulation.analysis().system(), before);
}

void check_sections(const std::string& deck, const std::vector<std::string>& names, double tolerance) {
    const Problem base = read(deck);
    for (const std::string& name : names) {
        INFO(name);
        const Variation varied(deck, name);
        SteppedRun simulation(request_of(base));
        REQUIRE(simulation.start());
        Sensitivities sensitivities(simulation.analysis(), base.analysis(), {varied.models()});
        sensitivities.start();
        while (!simulation.has_ended()) {
            sensitivities.note_before();
            REQUIRE(simulation.step());
            sensitivities.advance();
        }
        const std::vector<double> found =
            sensitivities.by(0).differentiate([](const System& system, const State& state, std::size_t) {
                return list_sections(system, state);
            });
        const double p = value_of(deck, name), h = 4e-3 * p;
        const auto difference = [&](double step) -> Eigen::VectorXd {
            const std::vector<double> up = end_sections(deck, name, p + step);
            const std::vector<double> down = end_sections(deck, name, p - step);
            return (Eigen::Map<const Eigen::VectorXd>(up.data(), static_cast<Eigen::Index>(up.size())) -
                    Eigen::Map<const Eigen::VectorXd>(down.data(), static_cast<Eigen::Index>(down.size()))) /
                   (2.0 * step);
        };
        const Eigen::VectorXd expected = (4.0 * difference(0.5 * h) - difference(h)) / 3.0;
        for (Eigen::Index i = 0; i < expected.size(); i += 3) {
            CAPTURE(i);
            const Vec3 is(&found[static_cast<std::size_t>(i)]), wanted = expected.segment<3>(i);
            // Where the end is free there are none.
            CHECK((is - wanted).norm() < tolerance * std::max(wanted.norm(), 1e-2 * expected.norm()));
        }
    }
}

}  // namespace

// They were up to 46 times off: `simo` elements distribute moments to their nodes by how these turned in a
// step, and derivatives were taken after it.
TEST_CASE("derivatives of section forces and strains along a rod are those of whole runs", "[sensitivity]") {
    const std::string element = GENERATE("objective", "simo");
    const std::string deck =
        replaced(make_carried(), "elements = 4", "elements = 4\nelement = \"" + element + "\"");
    INFO(element);
    check_sections(replaced(as_static(deck), "steps = 5", "steps = 1"), {"EI", "F", "L"}, 1e-7);
    check_sections(as_static(deck), {"EI", "F"}, 1e-7);
    check_sections(replaced(deck, "end_time = 0.6", "end_time = 0.2"), {"EI", "F"}, 1e-6);
}

}  // namespace gxrod::test
