// A run that is driven from outside: step by step, to a time, back to an earlier state, by inputs.
#include "run/stepped_run.hpp"

#include <stdexcept>

#include "deck/decks.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/sample.hpp"
#include "run/run_to_end.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;
using tools::run_problem;

const std::string swing = R"deck(gravity = [0, 0, -9.81]
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[body.b]
mass = 0.5
inertia = [0.1, 0.2, 0.2]
at = [2, 0, 0]
[joint.pin]
type = "hinge"
between = ["r.end", "b"]
axis = [0, 1, 0]
spring = { stiffness = 3 }
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, PUSH, 0]
[analysis]
kind = "dynamic"
end_time = 0.5
time_step = 0.02
)deck";

std::string with_push(const std::string& push, const std::string& more = "") {
    return replaced(swing, "PUSH", push) + more;
}

std::string with_integrator(const std::string& deck, const std::string& name) {
    return replaced(deck, "time_step = 0.02", "time_step = 0.02\nintegrator = \"" + name + "\"");
}

// A problem and the simulation that drives it.
struct Driven {
    explicit Driven(const std::string& deck) : problem(read(deck)), simulation(request()) {}

    RunRequest request() const { return {problem}; }
    void advance(double until) {
        while (simulation.time() < until) {
            REQUIRE(simulation.land_on(until) == until);
            REQUIRE(simulation.step());
        }
    }
    Vec3 tip() const { return simulation.analysis().state().previous[4].r; }

    Problem problem;
    SteppedRun simulation;
};

// Everything that moves at the last accepted state.
std::vector<double> bits_of(const SteppedRun& simulation) {
    std::vector<double> bits;
    const State& state = simulation.analysis().state();
    for (const NodeMotion& node : state.previous) {
        for (const Vec3& vector : {node.r, node.v, node.a, node.omega, node.alpha, Vec3(node.Lambda.vec())})
            bits.insert(bits.end(), vector.begin(), vector.end());
    }
    for (const JointState& joint : state.joints_previous) {
        bits.insert(bits.end(), joint.multipliers.begin(), joint.multipliers.end());
        bits.push_back(joint.turn);
    }
    const LedgerRow ledger = simulation.analysis().ledger_row();
    bits.insert(bits.end(), {ledger.external_work, ledger.strain_energy, ledger.energy_error});
    return bits;
}

}  // namespace

TEST_CASE("results are whole if what is made of a run at its end fails", "[analyses][simulation]") {
    const sample::ScratchFolder folder;
    const auto file = folder / "swing.vtkhdf";
    const Problem problem = read(with_push("1"));
    RunRequest request{problem};
    request.results = ResultsFileOptions{file};
    const auto fail = [](const SteppedRun&) { throw std::runtime_error("the disk is full"); };
    CHECK_THROWS_WITH(run_to_end(request, fail), "the disk is full");
    const Hdf5Reader results(file);
    CHECK(results.text_attribute("/", "status") == "complete");
    CHECK(results.numbers("/histories/time").back() == Approx(0.5));
}

TEST_CASE("A run driven step by step is the run", "[analyses][simulation]") {
    Driven driven(with_push("3"));
    REQUIRE(driven.simulation.start());
    long steps = 0;
    while (driven.simulation.step()) ++steps;
    CHECK(steps == 25);
    CHECK(driven.simulation.has_ended());
    CHECK_FALSE(driven.simulation.step());
    driven.simulation.close();
    const RunSummary whole = run_problem(driven.problem);
    CHECK(driven.simulation.summary().status == RunStatus::complete);
    CHECK(driven.simulation.summary().totals.newton_iterations == whole.totals.newton_iterations);
    CHECK(driven.simulation.summary().totals.largest_energy == whole.totals.largest_energy);
    CHECK(driven.simulation.summary().place == whole.place);
}

TEST_CASE("A simulation knows its end after the last step", "[analyses][simulation]") {
    Driven driven(with_push("3"));
    while (!driven.simulation.has_ended()) REQUIRE(driven.simulation.step());
    CHECK(driven.simulation.time() == 0.5);
    CHECK(driven.simulation.summary().status == RunStatus::complete);
}

TEST_CASE("A simulation that is closed before its end was interrupted", "[analyses][simulation]") {
    Driven driven(with_push("3"));
    for (int i = 0; i < 5; ++i) REQUIRE(driven.simulation.step());
    driven.simulation.close();
    CHECK(driven.simulation.summary().status == RunStatus::interrupted);
    CHECK(driven.simulation.summary().reason == "interrupted at t = 0.1");
}

TEST_CASE("A simulation goes through all stages", "[analyses][simulation]") {
    const std::string stages =
        "[[stage]]\nname = \"bend\"\nkind = \"static\"\nsteps = 2\n"
        "[[stage]]\nname = \"tones\"\nkind = \"modes\"\ncount = 2\n"
        "[[stage]]\nname = \"swing\"\nkind = \"dynamic\"\nend_time = 0.1\ntime_step = 0.02\n";
    const std::string deck = with_push("3");
    Driven driven(deck.substr(0, deck.find("[analysis]")) + stages);
    long steps = 0;
    while (driven.simulation.step()) ++steps;
    CHECK(steps == 7);
    CHECK(driven.simulation.summary().shapes.size() == 1);
    CHECK(driven.simulation.time() == Approx(0.1));  // statics end at t = 0
}

TEST_CASE("A simulation lands on any time, and its steps go on from there", "[analyses][simulation]") {
    const std::string scheme =
        GENERATE("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4");
    INFO(scheme);
    const std::string deck =
        replaced(replaced(with_integrator(with_push("3"), scheme), "time_step = 0.02", "time_step = 0.0025"),
                 "end_time = 0.5",
                 "end_time = 0.1");
    Driven reference(deck), landing(deck);
    while (reference.simulation.step()) {
    }
    for (const double time : {0.0123, 0.02, 0.0312499, 0.05000001, 0.0999}) {
        landing.advance(time);
        CHECK(landing.simulation.time() == time);
        CHECK(landing.simulation.analysis().state().time == time);
    }
    while (landing.simulation.step()) {
    }
    CHECK(landing.simulation.time() == 0.1);
    CHECK((landing.tip() - reference.tip()).norm() < 3e-6);
    CHECK_FALSE(landing.simulation.land_on(0.05));
    CHECK_FALSE(landing.simulation.land_on(0.2));
    CHECK(landing.simulation.land_on(0.1) == 0.1);
}

TEST_CASE("Steps chosen by their error land on a time, too", "[analyses][simulation]") {
    const std::string deck = replaced(with_integrator(with_push("3"), "sdirk-4"),
                                      "time_step = 0.02",
                                      "adaptive = { tolerance = 1e-6 }\ntime_step = 0.002");
    Driven driven(deck);
    driven.advance(0.1234);
    CHECK(driven.simulation.time() == 0.1234);
    const double before = driven.simulation.analysis().steps().time_step();
    CHECK(before > 1e-3);  // not that of the rest before the landing
    while (driven.simulation.step()) {
    }
    CHECK(driven.simulation.time() == 0.5);
}

TEST_CASE("A simulation returns to a saved state to the last bit", "[analyses][simulation]") {
    const std::string scheme =
        GENERATE("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4");
    INFO(scheme);
    Driven driven(
        with_integrator(with_push("\"3*u*t\"", "[input.u]\nvalue = 1\nhold = \"linear\"\n"), scheme));
    CHECK_THROWS_AS(driven.simulation.save(), std::logic_error);
    REQUIRE(driven.simulation.start());
    driven.advance(0.1234);
    driven.simulation.set_input("u", 4.0, 0.2);
    REQUIRE(driven.simulation.step());
    const RunCheckpoint checkpoint = driven.simulation.save();
    const std::vector<double> there = bits_of(driven.simulation);
    while (driven.simulation.step()) {
    }
    const std::vector<double> end = bits_of(driven.simulation);
    const RunTotals totals = driven.simulation.summary().totals;

    driven.simulation.restore(checkpoint);
    CHECK_FALSE(driven.simulation.has_ended());
    CHECK(bits_of(driven.simulation) == there);
    while (driven.simulation.step()) {
    }
    CHECK(bits_of(driven.simulation) == end);
    CHECK(driven.simulation.summary().totals.newton_iterations == totals.newton_iterations);

    // In another simulation of the same deck, too.
    Driven other(driven.problem.record.text);
    other.simulation.restore(checkpoint);
    while (other.simulation.step()) {
    }
    CHECK(bits_of(other.simulation) == end);
    Driven foreign(replaced(with_push("3"), "elements = 4", "elements = 5"));
    CHECK_THROWS_AS(foreign.simulation.restore(checkpoint), std::invalid_argument);
}

TEST_CASE("What ended a run is forgotten where it returns to before that", "[analyses][simulation]") {
    Driven driven(with_push("\"abs(t - 0.0801) < 1e-9 ? 1/(t - t) : 3\""));
    REQUIRE(driven.simulation.start());
    const RunCheckpoint checkpoint = driven.simulation.save();
    REQUIRE(driven.simulation.land_on(0.0801));
    while (driven.simulation.step()) {
    }
    CHECK(driven.simulation.summary().status == RunStatus::failed);
    CHECK(driven.simulation.summary().deck_fault);
    driven.simulation.restore(checkpoint);
    CHECK(driven.simulation.summary().status == RunStatus::running);
    CHECK_FALSE(driven.simulation.summary().deck_fault);
    CHECK(driven.simulation.summary().reason.empty());
    while (driven.simulation.step()) {
    }
    CHECK(driven.simulation.summary().status == RunStatus::complete);
}

TEST_CASE("A simulation that writes results does not go back", "[analyses][simulation]") {
    const sample::ScratchFolder folder;
    Driven driven(with_push("3"));
    RunRequest request = driven.request();
    request.results = ResultsFileOptions{folder / "results"};
    SteppedRun simulation(request);
    REQUIRE(simulation.step());
    const RunCheckpoint checkpoint = simulation.save();
    CHECK_THROWS_WITH(simulation.restore(checkpoint), Contains("writes results"));
}

TEST_CASE("An input that jumps acts as a function that jumps between steps", "[analyses][simulation]") {
    Driven planned(with_push("\"t < 0.11 ? 1 : t < 0.31 ? 5 : -2\"")),
        driven(with_push("\"u\"", "[input.u]\nvalue = 1\n"));
    while (planned.simulation.step()) {
    }
    REQUIRE(driven.simulation.start());
    while (!driven.simulation.has_ended()) {
        const double time = driven.simulation.time();
        if (time > 0.09) driven.simulation.set_input("u", time > 0.29 ? -2.0 : 5.0, 0.0);
        REQUIRE(driven.simulation.step());
    }
    CHECK((driven.tip() - planned.tip()).norm() < 1e-12);
}

TEST_CASE("A linear input is a line over the time that is advanced", "[analyses][simulation]") {
    const std::string ramp = "[function.ramp]\ntable = [[0, 0], [0.1, 0], [0.3, 8], [0.5, 8]]\n";
    Driven planned(with_push("\"2*ramp(t)\"", ramp)),
        driven(with_push("\"twice(u)\"",
                         "[function.twice]\nexpression = \"2*t\"\n[input.u]\nhold = \"linear\"\n"));
    while (planned.simulation.step()) {
    }
    REQUIRE(driven.simulation.start());
    driven.advance(0.1);
    driven.simulation.set_input("u", 8.0, 0.3);
    driven.advance(0.3);
    while (driven.simulation.step()) {
    }
    CHECK((driven.tip() - planned.tip()).norm() < 1e-10);
}

TEST_CASE("An input that a function of the deck reads has the time of the run", "[analyses][simulation]") {
    Driven driven(
        with_push("\"f(100*t)\"", "[function.f]\nexpression = \"u\"\n[input.u]\nhold = \"linear\"\n"));
    REQUIRE(driven.simulation.start());
    driven.simulation.set_input("u", 3.0, 0.2);
    CHECK(driven.problem.model.loads[0].force[1](0.1) == Approx(1.5));
}

TEST_CASE("Without t an input ramps with the load factor", "[analyses][simulation]") {
    const std::string statics = "kind = \"static\"\nsteps = 4\n";
    const auto make = [&](const std::string& deck) {
        return replaced(deck, "kind = \"dynamic\"\nend_time = 0.5\ntime_step = 0.02\n", statics);
    };
    const std::string input = "[input.u]\nvalue = 2\n";
    Driven constant(make(with_push("3"))), driven(make(with_push("\"1.5*u\"", input)));
    while (constant.simulation.step()) {
    }
    while (driven.simulation.step()) {
    }
    CHECK(driven.tip() == constant.tip());
    // Along a rod, too.
    const auto along = [&](const std::string& value) {
        return make(replaced(swing,
                             "at = \"r.end\"\nforce = [0, PUSH, 0]",
                             "on = \"r\"\nforce_per_length = [0, " + value + ", 0]"));
    };
    Driven even(along("3")), by_input(along("\"1.5*u\"") + input);
    while (even.simulation.step()) {
    }
    while (by_input.simulation.step()) {
    }
    CHECK((by_input.tip() - even.tip()).norm() < 1e-12);
}

TEST_CASE("Inputs are recorded, and resumed to the last bit", "[analyses][simulation]") {
    const sample::ScratchFolder folder;
    const std::string deck =
        with_push("\"u\"", "[input.u]\nvalue = 1\nhold = \"linear\"\n[output]\nevery = 5\n");
    const Problem problem = read(deck);
    const auto drive = [&](const std::string& name, double stop) {
        RunRequest request{problem, ResultsFileOptions{folder / name}};
        SteppedRun simulation(request);
        simulation.start();
        while (!simulation.has_ended() && simulation.time() < stop) {
            if (simulation.time() == 0.1) simulation.set_input("u", 4.0, 0.3);
            simulation.step();
        }
        simulation.close();
    };
    drive("whole", 1.0);
    for (const std::shared_ptr<Input>& input : problem.model.inputs) input->recall({.planned = 1.0});
    drive("parts", 0.19);
    tools::resume_problem(read(deck), folder / "parts");
    const Hdf5Reader whole(folder / "whole"), parts(folder / "parts");
    const std::vector<double> u = whole.numbers("/inputs/u");
    REQUIRE(u.size() == 26);
    CHECK(u[5] == 1.0);
    CHECK(u[10] == Approx(2.5));
    CHECK(u[25] == 4.0);
    CHECK(parts.numbers("/inputs/u") == u);
    CHECK(parts.numbers("/ledger/external_work") == whole.numbers("/ledger/external_work"));
    // A deck with another value counts.
    drive("changed", 0.19);
    tools::resume_problem(read(replaced(deck, "value = 1", "value = -7")), folder / "changed");
    CHECK(Hdf5Reader(folder / "changed").numbers("/inputs/u").back() == -7.0);
}

TEST_CASE("Inputs that cannot be set are refused", "[analyses][simulation]") {
    Driven driven(with_push("\"u\"", "[input.u]\n"));
    REQUIRE(driven.simulation.start());
    CHECK_THROWS_WITH(driven.simulation.set_input("v", 1.0, 0.0), Contains("no input.v"));
    CHECK_THROWS_WITH(driven.simulation.set_input("u", std::nan(""), 0.0), Contains("cannot be nan"));
}

}  // namespace gxrod::test
