// Derivatives that are carried along against differences of whole runs, extrapolated.
#include "sensitivity/forward_sensitivity.hpp"

#include <fmt/format.h>

#include <array>

#include "deck/decks.hpp"
#include "run/simulation.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A damped rod that a following force and a moment swing; a body at its end turns on a hinge.
const std::string swing = R"deck(gravity = [0, 0, -9.81]
[parameters]
EI = 6
rho = 1.2
F = 3
L = 2
c = 0.02
angle = 0.3
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }
inertia = { rhoA = "rho", rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
damping = { kelvin_voigt = "c", mass_proportional = 0.1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = ["L*cos(angle)", "L*sin(angle)", 0] }
elements = 4
[body.b]
mass = 0.5
inertia = [0.1, 0.2, 0.2]
at = ["L*cos(angle)", "L*sin(angle)", 0]
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, "F*sin(4*t)", 0]
moment = [0.5, 0, "F/4"]
frame = "follower"
[analysis]
kind = "dynamic"
end_time = 0.6
time_step = 0.02
newton = { tolerance = 1e-12 }
)deck";

const std::string hinge =
    "[joint.pin]\ntype = \"hinge\"\nbetween = [\"r.end\", \"b\"]\naxis = [0, 1, 0]\nspring = { stiffness = 3 "
    "}\n";

// The body on the rod's end itself.
std::string make_carried() {
    return replaced(swing,
                    "inertia = [0.1, 0.2, 0.2]\nat = [\"L*cos(angle)\", \"L*sin(angle)\", 0]",
                    "inertia = [0.1, 0.2, 0.2]\nat = \"r.end\"");
}

std::string as_static(const std::string& deck) {
    return replaced(
        replaced(
            deck, "kind = \"dynamic\"\nend_time = 0.6\ntime_step = 0.02", "kind = \"static\"\nsteps = 5"),
        "sin(4*t)",
        "t");
}

std::string with_integrator(const std::string& deck, const std::string& name) {
    return replaced(deck, "time_step = 0.02", "time_step = 0.02\nintegrator = \"" + name + "\"");
}

std::string set(const std::string& deck, const std::string& name, double value) {
    const std::size_t at = deck.find("\n" + name + " = ") + 1;
    const std::size_t end = deck.find('\n', at);
    return std::string(deck).replace(at, end - at, fmt::format("{} = {:.17g}", name, value));
}

double value_of(const std::string& deck, const std::string& name) {
    return std::stod(deck.substr(deck.find("\n" + name + " = ") + name.size() + 4));
}

RunRequest request_of(const Problem& problem) {
    RunRequest request{problem.model, problem.analysis, problem.output, problem.record, {}};
    request.stages = problem.stages;
    return request;
}

// The deck's models for values of a number next to its own.
class Variation {
  public:
    Variation(const std::string& deck, const std::string& name) : step_(3e-4 * value_of(deck, name)) {
        const double p = value_of(deck, name);
        for (const int steps : {1, -1, 2, -2}) problems_.push_back(read(set(deck, name, p + steps * step_)));
    }
    VariedModels models() const {
        return {{problems_[0].model, problems_[1].model, step_},
                {problems_[2].model, problems_[3].model, 2.0 * step_}};
    }

  private:
    std::vector<Problem> problems_;
    double step_;
};

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
    Simulation simulation(request_of(problem));
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
    Simulation simulation(request_of(base));
    REQUIRE(simulation.start());
    Sensitivities sensitivities(simulation.analysis(), base.analysis, {varied.models()});
    sensitivities.start(simulation.analysis());
    while (!simulation.has_ended()) {
        sensitivities.note_before(simulation.analysis());
        REQUIRE(simulation.step());
        sensitivities.advance(simulation.analysis());
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

const std::vector<std::string> all_names{"EI", "rho", "F", "L", "c", "angle"};

}  // namespace

TEST_CASE("derivatives of motions are those of whole runs", "[sensitivity]") {
    const std::string scheme = GENERATE("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha");
    INFO(scheme);
    check_all(with_integrator(make_carried(), scheme), all_names, true, 1e-8);
}

TEST_CASE("derivatives of motions of elements with memory and of higher order", "[sensitivity]") {
    check_all(replaced(make_carried(), "elements = 4", "elements = 4\nelement = \"simo\""),
              {"EI", "L"},
              true,
              1e-8);
    check_all(replaced(make_carried(), "elements = 4", "elements = 2\norder = 2"), {"EI", "L"}, true, 1e-8);
}

TEST_CASE("derivatives of equilibria of mechanisms are those of whole runs", "[sensitivity]") {
    check_all(as_static(swing + hinge), {"EI", "F", "L", "angle"}, false, 1e-8);
}

TEST_CASE("derivatives of equilibria are those of whole runs", "[sensitivity]") {
    check_all(as_static(make_carried()), {"EI", "F", "L", "angle"}, false, 1e-8);
    check_all(replaced(as_static(make_carried()), "elements = 4", "elements = 4\nelement = \"simo\""),
              {"EI", "L"},
              false,
              1e-8);
}

TEST_CASE("what cannot be differentiated is refused", "[sensitivity]") {
    const Problem base = read(make_carried());
    Simulation simulation(request_of(base));
    REQUIRE(simulation.start());
    const Problem other = read(replaced(make_carried(), "elements = 4", "elements = 5"));
    CHECK_THROWS_WITH(Sensitivities(simulation.analysis(), base.analysis, {vary(other, base)}),
                      Contains("which nodes and elements"));
    const Problem held = read(make_carried() + "[[support]]\nat = \"r.end\"\nfix = \"z\"\n");
    CHECK_THROWS_WITH(Sensitivities(simulation.analysis(), base.analysis, {vary(held, base)}),
                      Contains("which motions are held"));
    const Problem staged = read(with_integrator(make_carried(), "sdirk-4"));
    Simulation other_scheme(request_of(staged));
    CHECK_THROWS_WITH(Sensitivities(other_scheme.analysis(), staged.analysis, {vary(base, base)}),
                      Contains("newmark-simplified"));
    const Problem jointed = read(swing + hinge);
    Simulation mechanism(request_of(jointed));
    CHECK_THROWS_WITH(Sensitivities(mechanism.analysis(), jointed.analysis, {vary(jointed, jointed)}),
                      Contains("those of equilibria with all joints"));
}

TEST_CASE("functions of a state are differentiated along it", "[sensitivity]") {
    const std::string deck = as_static(make_carried());
    const double p = value_of(deck, "EI");
    const Problem base = read(deck);
    const Variation varied(deck, "EI");
    Simulation simulation(request_of(base));
    REQUIRE(simulation.start());
    Sensitivities sensitivities(simulation.analysis(), base.analysis, {varied.models()});
    sensitivities.start(simulation.analysis());
    while (!simulation.has_ended()) {
        sensitivities.note_before(simulation.analysis());
        REQUIRE(simulation.step());
        sensitivities.advance(simulation.analysis());
    }
    const auto energy = [](const System& system, const State& state) {
        return system.compute_balance(state, 1.0).strain_energy;
    };
    const std::vector<double> derivative = sensitivities.by(0).differentiate_function(
        simulation.analysis().state(), [&](const System& system, const State& state, std::size_t) {
            return std::vector{energy(system, state)};
        });
    const auto run = [&](double value) {
        const Problem problem = read(set(deck, "EI", value));
        Simulation other(request_of(problem));
        while (other.step()) {
        }
        return energy(other.analysis().system(), other.analysis().state());
    };
    const double k = 2e-3 * p;
    const auto difference = [&](double step) { return (run(p + step) - run(p - step)) / (2.0 * step); };
    CHECK(derivative[0] == Approx((4.0 * difference(0.5 * k) - difference(k)) / 3.0).epsilon(1e-8));
}

}  // namespace gxrod::test
