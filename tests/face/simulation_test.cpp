#include "face/simulation.hpp"

#include "deck/decks.hpp"
#include "face/gxrod.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string swing = R"(gravity = [0, 0, -9.81]
[parameters]
EI = 6.0
[input.push]
value = 0.5
hold = "linear"
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, "push", 0]
[spring.line]
between = ["ground", "r.end"]
at_a = [2, 0, 1]
stiffness = 3.0
[[history]]
name = "tip"
at = "r.end"
quantities = ["position", "velocity", "orientation"]
[[history]]
name = "line"
at = "line"
quantities = ["elongation"]
)";

const std::string moves = "[analysis]\nkind = \"dynamic\"\nend_time = 0.5\ntime_step = 0.02\n";
const std::string stages = R"([[stage]]
name = "sag"
kind = "static"
steps = 2
[[stage]]
name = "move"
kind = "dynamic"
end_time = 0.1
time_step = 0.02
)";

Deck deck_of(const std::string& analysis) { return Deck::from_text(swing + analysis); }

}  // namespace

TEST_CASE("the lowest point of a swing takes four lines", "[face]") {
    Simulation run(deck_of(moves).build());
    double lowest = run["tip"].position.z();
    while (run.step()) lowest = std::min(lowest, run["tip"].position.z());

    const Problem problem = read(swing + moves);
    SteppedRun same(RunRequest{problem});
    same.start();
    double expected = 0.0;
    while (same.step()) expected = std::min(expected, same.analysis().state().previous.back().r.z());
    CHECK(expected < -0.05);
    CHECK(lowest == expected);
    CHECK(run.time() == 0.5);
    CHECK(run.finished());
    CHECK(!run.step());
    CHECK(run.summary().status == RunStatus::complete);
}

TEST_CASE("a simulation goes through all stages", "[face]") {
    Simulation run(deck_of(stages).build());
    std::vector<std::string> names;
    while (run.step()) names.push_back(run.stage());
    CHECK(names == std::vector<std::string>{"sag", "sag", "move", "move", "move", "move", "move"});
    CHECK(run.times().size() == 8);
    CHECK(run.records("tip", "position").size() == 24);
    CHECK(run.ledgers().size() == 8);
}

TEST_CASE("values are numbers, vectors and quaternions by their names", "[face]") {
    Simulation run(deck_of(moves).build());
    const Values tip = run["tip"];
    const Vec3 start = tip.position;
    CHECK(start == Vec3(2, 0, 0));
    CHECK(run.advance(0.1) == 5);
    CHECK(run.time() == 0.1);
    CHECK(tip.position.vector() == run.nodes().back().r);
    CHECK(tip["velocity"].numbers().size() == 3);
    const Quat turned = tip.orientation;
    CHECK(std::abs(turned.dot(run.nodes().back().Lambda)) > 1.0 - 1e-14);
    const double elongation = run["line"]["elongation"];
    CHECK(std::abs(elongation - ((run.nodes().back().r - Vec3(2, 0, 1)).norm() - 1.0)) < 1e-14);
    CHECK(tip.names() == std::vector<std::string>{"position", "velocity", "orientation"});
    CHECK_THROWS_WITH(run["tpi"], Contains("no history \"tpi\"") && Contains("did you mean \"tip\"?"));
    CHECK_THROWS_WITH(tip.acceleration.vector(), Contains("no quantity of history tip \"acceleration\""));
    CHECK_THROWS_WITH(tip.position.number(), Contains("has 3 numbers"));
    CHECK_THROWS_AS(run["line"]["force"].number(), UnknownNameError);
    CHECK_THROWS_AS(Simulation(deck_of(moves).build(), {.record = {{"tpi"}}}), UnknownNameError);
}

TEST_CASE("an input of a simulation counts from the next step on", "[face]") {
    Simulation run(deck_of(moves).build());
    CHECK(run.input("push") == 0.5);
    run.set("push", 2.5);
    CHECK(run.input("push") == 2.5);
    run.advance(0.1);
    const Problem problem = read(swing + moves);
    SteppedRun same(RunRequest{problem});
    same.start();
    same.set_input("push", 2.5, 0.1);
    for (int i = 0; i < 5; ++i) {
        same.land_on(0.1);
        same.step();
    }
    CHECK(run.nodes().back().r == same.analysis().state().previous.back().r);
    CHECK_THROWS_AS(run.set("pull", 1.0), UnknownNameError);
    CHECK_THROWS_WITH(run.set("push", std::nan("")), Contains("cannot be nan"));
}

TEST_CASE("a simulation returns to a checkpoint to the last bit", "[face]") {
    Simulation run(deck_of(moves).build());
    run.advance(std::nullopt, 7);
    const Checkpoint checkpoint = run.save();
    CHECK(checkpoint.time() == run.time());
    run.run();
    const Vec3 end = run["tip"].position;
    const std::vector<double> places = run.records("tip", "position");
    run.set("push", 100.0);
    run.restore(checkpoint);
    CHECK(run.times().size() == 8);
    run.run();
    CHECK(run["tip"].position.vector() == end);
    CHECK(run.records("tip", "position") == places);
    Simulation other(deck_of(moves).build());
    other.restore(checkpoint);
    other.run();
    CHECK(other["tip"].position.vector() == end);
}

namespace {

// A damped rod in water that carries a body, with a tendon and a support that yields; all that it shows.
const std::string shown = R"(gravity = [0, 0, -9.81]
[fluid]
density = 1000
surface = 0
current = { velocity = [0.3, 0.1, 0] }
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
damping = { kelvin_voigt = 0.02 }
fluid = { outer_diameter = 0.02, drag = { normal = 1.0 }, added_mass = { normal = 1.0 } }
[rod.r]
section = "s"
line = { from = [0, 0, -1], to = [2, 0, -1] }
elements = 4
order = ORDER
element = "KIND"
y_axis = [0, 1, 0]
[body.b]
mass = 0.5
inertia = [0.1, 0.2, 0.2]
at = [2, 0, -1]
[joint.pin]
type = "hinge"
between = ["r.end", "b"]
axis = [0, 1, 0]
spring = { stiffness = 3 }
[tendon.t]
on = "r"
offset = [0, 0.05]
tension = 2
to = 0.75
[spring.line]
between = ["ground", "b"]
at_a = [2, 0, 0]
stiffness = 3.0
[[support]]
at = "r.start"
fix = "all"
[[support]]
at = "r@0.5"
stiffness = { z = 20 }
[[load]]
at = "r.end"
force = [0, 3, 0]
[[history]]
name = "foot"
at = "r.start"
quantities = ["reaction_force", "reaction_moment", "force", "moment", "strain", "curvature", "effective_tension"]
[[history]]
name = "middle"
at = "r@0.5"
quantities = ["reaction_force", "position", "velocity", "acceleration", "angular_velocity", "quaternion", "fluid_force", "wet_fraction", "water_velocity", "bending_moment"]
[[history]]
name = "body"
at = "b"
quantities = ["position", "quaternion", "centre_of_mass"]
[[history]]
name = "pin"
at = "pin"
quantities = ["angle", "angle_rate", "force", "moment", "gap"]
[[history]]
name = "tendon"
at = "t"
quantities = ["tendon_length", "tendon_tension"]
[[history]]
name = "line"
at = "line"
quantities = ["elongation", "axial_force"]
)";

std::vector<double> all_that_is_shown(Simulation& run) {
    std::vector<double> all;
    for (std::size_t history = 0; history < run.problem().output.histories.size(); ++history) {
        for (std::size_t i = 0; i < run.list_quantities(history).size(); ++i) {
            const std::vector<double> values = run.compute(history, i);
            all.insert(all.end(), values.begin(), values.end());
        }
    }
    const LedgerRow ledger = run.ledger();
    all.insert(all.end(), {ledger.strain_energy, ledger.external_work, ledger.energy_error});
    return all;
}

}  // namespace

TEST_CASE("all that can be seen before a checkpoint has the same bits after it", "[face]") {
    const std::string analysis =
        GENERATE("kind = \"static\"\nsteps = 5\n",
                 "kind = \"quasi-static\"\nend_time = 0.1\ntime_step = 0.02\n",
                 "kind = \"dynamic\"\nend_time = 0.1\ntime_step = 0.02\n",
                 "kind = \"dynamic\"\nend_time = 0.1\ntime_step = 0.02\nintegrator = \"generalized-alpha\"\n",
                 "kind = \"dynamic\"\nend_time = 0.1\ntime_step = 0.02\nintegrator = \"sdirk-4\"\n");
    const std::string kind = GENERATE("objective", "simo");
    const std::string order = GENERATE("1", "3");
    INFO(analysis << kind << order);
    Simulation run(
        Deck::from_text(replaced(replaced(shown, "KIND", kind), "ORDER", order) + "[analysis]\n" + analysis)
            .build());
    for (int steps : {0, 3}) {
        run.advance(std::nullopt, steps);
        const Checkpoint checkpoint = run.save();
        const std::vector<double> before = all_that_is_shown(run);
        run.advance(std::nullopt, 1);
        run.restore(checkpoint);
        CHECK(all_that_is_shown(run) == before);
        if (steps > 0) CHECK(run["foot"]["reaction_force"].vector().norm() > 0.1);
    }
}

TEST_CASE("results are complete once a run has ended, or its simulation", "[face]") {
    const sample::ScratchFolder folder;
    const auto status_of = [&](const std::string& name) {
        return Hdf5Reader(folder / name).text_attribute("/", "status");
    };
    Simulation whole(deck_of(moves).build(), {.results = folder / "whole"});
    whole.run();
    CHECK(status_of("whole") == "complete");
    {
        Simulation part(deck_of(moves).build(), {.results = folder / "part"});
        part.step();
        CHECK_THROWS_WITH(part.restore(part.save()), Contains("writes results"));
        CHECK(status_of("part") == "running");
    }
    CHECK(status_of("part") == "interrupted");
}

TEST_CASE("a step that fails is an exception, and the state stays", "[face]") {
    const std::string short_of =
        "[analysis]\nkind = \"static\"\nsteps = 1\nnewton = { max_iterations = 1 }\n";
    Simulation run(deck_of(short_of).set("load[0].force", {0.0, 0.0, -1e4}).build());
    try {
        run.run();
        FAIL("the load was reached");
    } catch (const ConvergenceError& error) {
        REQUIRE(error.failure);
        CHECK(std::string(name_of(error.failure->outcome)) == "out of iterations");
        CHECK_THAT(error.what(), Contains("did not converge"));
    }
    CHECK(run.time() < 1.0);
    CHECK_THROWS_AS(run.step(), ConvergenceError);
    Simulation jumps(deck_of(moves).set("load[0].force[2]", "1/(t-0.031)").build());
    CHECK_THROWS_AS(jumps.advance(0.031), EvaluationError);
    CHECK(jumps.time() == 0.02);
}

TEST_CASE("derivatives are carried along by the names of numbers", "[face]") {
    const Deck deck = deck_of(moves);
    std::vector<VariedNumber> variations;
    variations.push_back(vary(deck, "EI"));
    variations.push_back(vary(deck, "load[0].force[0]"));
    Simulation run(deck.build(), {.sensitivities = std::move(variations)});
    run.run();
    const auto end_of = [&](double EI) {
        Simulation other(Deck(deck).set("parameters.EI", EI).build());
        other.run();
        return other["tip"].position.vector();
    };
    const Vec3 difference = (end_of(6.0 + 1e-3) - end_of(6.0 - 1e-3)) / 2e-3;
    CHECK((run["tip"].derivative("EI").position.vector() - difference).norm() < 1e-4 * difference.norm());
    CHECK(run["tip"].derivative("load[0].force[0]").position.vector().norm() > 1e-5);
    CHECK_THROWS_AS(run["tip"].derivative("EJ"), UnknownNameError);
    CHECK_THROWS_WITH(vary(deck, "EJ"), Contains("no number of the deck \"EJ\""));
    CHECK_THROWS_WITH(vary(deck, "section.s.stiffness.EIy"), Contains("not a number"));
    std::vector<VariedNumber> of_stages;
    of_stages.push_back(vary(deck_of(stages), "EI"));
    Simulation through(deck_of(stages).build(), {.sensitivities = std::move(of_stages)});
    through.run();
    const auto run_to_end = [](double EI) {
        Simulation one(deck_of(stages).set("parameters.EI", EI).build());
        one.run();
        return one["tip"].position.z();
    };
    const double h = 6e-3;
    const double expected = (run_to_end(6.0 + h) - run_to_end(6.0 - h)) / (2.0 * h);
    CHECK(std::abs(expected) > 1e-6);
    CHECK(through["tip"].derivative("EI").position.z() == Approx(expected).epsilon(1e-5));
}

}  // namespace gxrod::test
