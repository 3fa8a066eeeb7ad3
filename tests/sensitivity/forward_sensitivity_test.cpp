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

Eigen::VectorXd extrapolate(const std::string& deck, const std::string& name, bool has_rates) {
    const double p = value_of(deck, name);
    const auto difference = [&](double h) -> Eigen::VectorXd {
        return (run_with(deck, name, p + h, has_rates) - run_with(deck, name, p - h, has_rates)) / (2.0 * h);
    };
    const double h = 1e-2 * p;
    const Eigen::VectorXd coarse = difference(h), middle = difference(0.5 * h), fine = difference(0.25 * h);
    return (64.0 * fine - 20.0 * middle + coarse) / 45.0;
}

Eigen::VectorXd carry_along(const std::string& deck, const std::string& name, bool has_rates) {
    const Problem base = read(deck);
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
    const StateDirection::OfNode& node = sensitivities.by(0).direction().nodes[tip];
    Eigen::VectorXd derivative(has_rates ? 12 : 3);
    derivative.head<3>() = node.r;
    if (has_rates) derivative.tail<9>() << node.v, node.omega, node.a;
    return derivative;
}

void check_all(const std::string& deck,
               const std::vector<std::string>& names,
               bool has_rates,
               double tolerance) {
    for (const std::string& name : names) {
        INFO(name);
        const Eigen::VectorXd expected = extrapolate(deck, name, has_rates);
        const Eigen::VectorXd derivative = carry_along(deck, name, has_rates);
        for (Eigen::Index i = 0; i < expected.size(); i += 3) {
            CAPTURE(i);
            // Round-off of accelerations is that of positions over Δt².
            const double allowed = (i == accelerations ? 10.0 : 1.0) * tolerance;
            CHECK((derivative.segment<3>(i) - expected.segment<3>(i)).norm() <
                  allowed * expected.segment<3>(i).norm());
        }
    }
}

// Stages have more round-off: those of a quarter of Δt divide it by their square.
constexpr double with_stages = 1e-7;
const std::vector<std::string> all_names{"EI", "rho", "F", "L", "c", "angle"};

}  // namespace

TEST_CASE("derivatives of motions are those of whole runs", "[sensitivity]") {
    const std::string scheme = GENERATE("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha");
    INFO(scheme);
    check_all(with_integrator(make_carried(), scheme), all_names, true, 1e-8);
}

TEST_CASE("derivatives of motions by a scheme of several stages are those of whole runs", "[sensitivity]") {
    check_all(with_integrator(make_carried(), "sdirk-4"), all_names, true, with_stages);
}

TEST_CASE("derivatives of motions by an explicit scheme are those of whole runs", "[sensitivity]") {
    check_all(as_explicit(make_carried()), {"EI", "rho", "L"}, true, with_stages);
}

TEST_CASE("derivatives of creep are those of whole runs", "[sensitivity]") {
    const std::string deck = replaced(make_carried(), "kind = \"dynamic\"", "kind = \"quasi-static\"");
    check_all(deck, {"EI", "F", "L", "c"}, false, with_stages);
}

TEST_CASE("derivatives of motions of mechanisms are those of whole runs", "[sensitivity]") {
    const std::string scheme = GENERATE("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha");
    INFO(scheme);
    check_all(with_integrator(swinging_rod + hinged_end, scheme), {"EI", "rho", "L", "angle"}, true, 1e-8);
}

TEST_CASE("derivatives of mechanisms by a scheme of several stages are those of whole runs",
          "[sensitivity]") {
    check_all(with_integrator(swinging_rod + hinged_end, "sdirk-4"),
              {"EI", "rho", "L", "angle"},
              true,
              with_stages);
}

TEST_CASE("derivatives of mechanisms by an explicit scheme are those of whole runs", "[sensitivity]") {
    check_all(as_explicit(swinging_rod + hinged_end), {"EI", "rho", "L"}, true, with_stages);
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
    check_all(with_integrator(deck, "sdirk-4"), {"L"}, true, with_stages);
    check_all(as_explicit(deck), {"L"}, true, with_stages);
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
