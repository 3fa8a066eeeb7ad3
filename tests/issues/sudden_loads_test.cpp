#include <fmt/format.h>

#include <map>

#include "check/model_examination.hpp"
#include "deck/decks.hpp"
#include "elements/spring_law_energy.hpp"
#include "results/sample.hpp"
#include "study/deck_run.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

// Quasi-statics in which something comes at once, or a support moves; and what follows a stage.

namespace gxrod::test {
namespace {

using tools::resume_problem;
using tools::run_problem;

// The value of a history's component by the time of each row.
using Rows = std::map<double, double>;

struct Trace {
    Rows rows;
    LedgerRow ledger;  // of the last row
};

Trace trace(const std::string& deck,
            const std::string& history,
            const std::string& quantity,
            int component,
            const std::vector<std::string>& overrides = {}) {
    DeckRun run("deck", deck, overrides);
    Trace traced;
    run.run([&] {
        traced.rows[std::round(1e9 * run.time()) / 1e9] = run.value(history, quantity)[component];
        traced.ledger = run.analysis().ledger_row();
    });
    return traced;
}

// A Maxwell chain: EI (1 + 1.5 e^(−t/0.4) + 0.5 e^(−t/3)), EI = 1000, length 1.
std::string make_creep(const std::string& moment, const std::string& law = "prony") {
    const std::string memory =
        law == "prony" ? "law = { viscoelastic = { prony = [[1.5, 0.4], [0.5, 3.0]] } }\n" : law;
    return R"(plane = "xy"
[section.s]
stiffness = { EA = 1e6, GAy = 1e7, GAz = 1e7, GJ = 1000, EIy = 1000, EIz = 1000 }
)" + memory +
           R"([rod.b]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 4
order = 2
[[support]]
at = "b.start"
fix = "all"
[[load]]
at = "b.end"
moment = [0, 0, )" +
           moment + R"(]
[[history]]
name = "end"
at = "b.end"
quantities = ["rotation_vector"]
[analysis]
kind = "quasi-static"
end_time = 4.0
steps = 40
)";
}

// The chain under a curvature that starts at once: the creep by its own differential equations, steps of
// Heun's rule.
double creep_of_chain(double moment, double time) {
    constexpr double E = 1000.0, E1 = 1500.0, E2 = 500.0, t1 = 0.4, t2 = 3.0;
    // Stresses of the branches, s' = E k' − s/t, and M = E k + s1 + s2 gives k'.
    double k = moment / (E + E1 + E2), s1 = E1 * k, s2 = E2 * k;
    const auto rate = [&](double a, double b) { return (a / t1 + b / t2) / (E + E1 + E2); };
    const int steps = 40000;
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const double r = rate(s1, s2);
        const double p1 = s1 + h * (E1 * r - s1 / t1), p2 = s2 + h * (E2 * r - s2 / t2);
        const double q = rate(p1, p2);
        k += 0.5 * h * (r + q);
        s1 += 0.5 * h * (E1 * (r + q) - s1 / t1 - p1 / t1);
        s2 += 0.5 * h * (E2 * (r + q) - s2 / t2 - p2 / t2);
    }
    return k;
}

const std::string bar = R"(gravity = [0, 0, -1]
[section.bar]
stiffness = { EA = 1e3, GAy = 500, GAz = 500, GJ = 1, EIy = 1, EIz = 1.5 }
inertia = { rhoA = 1, rhoJ = 0.02, rhoIy = 0.01, rhoIz = 0.01 }
[rod.beam]
section = "bar"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 6
order = 2
y_axis = [0, 1, 0]
[[history]]
name = "tip"
at = "beam.end"
quantities = ["displacement", "rotation_vector"]
)";
const std::string clamped = "[[support]]\nat = \"beam.start\"\nfix = \"all\"\n";
const std::string at_once = "[analysis]\nkind = \"quasi-static\"\nend_time = 0.5\nsteps = 25\n";

}  // namespace

TEST_CASE("A load that comes at once bends a relaxing rod at once, and creep follows", "[issues]") {
    CHECK(creep_of_chain(100.0, 0.1) == Approx(0.0374552).epsilon(2e-6));
    CHECK(creep_of_chain(100.0, 4.0) == Approx(0.0826457).epsilon(2e-6));
    Rows errors;
    for (const int steps : {40, 80}) {
        const Rows rows =
            trace(make_creep("100"), "end", "rotation_vector", 2, {fmt::format("analysis.steps={}", steps)})
                .rows;
        CHECK(rows.at(0.0) == Approx(100.0 / 3000.0).epsilon(1e-7));
        CHECK(rows.at(0.1) == Approx(0.0374552).epsilon(1e-3));
        errors[steps] = std::abs(rows.at(0.5) - creep_of_chain(100.0, 0.5));
    }
    CHECK(errors[80] < 0.35 * errors[40]);
    const Rows adaptive =
        trace(make_creep("100"), "end", "rotation_vector", 2, {"analysis.adaptive.tolerance=1e-6"}).rows;
    CHECK(adaptive.at(0.0) == Approx(100.0 / 3000.0).epsilon(1e-7));
    CHECK(adaptive.at(4.0) == Approx(0.0826457).epsilon(1e-5));
}

TEST_CASE("A load that jumps later does so between steps", "[issues]") {
    // On the times of equal steps and off them, by either side's comparison: the creep of both loads adds.
    for (const std::string jump : {"1.0", "1.03", "1.2345"}) {
        for (const std::string compare : {"<", "<="}) {
            const std::string moment = "\"t " + compare + " " + jump + " ? 100 : 250\"";
            INFO(moment);
            const Rows rows = trace(make_creep(moment), "end", "rotation_vector", 2).rows;
            const double later = 4.0 - std::stod(jump);
            const double exact = creep_of_chain(100.0, 4.0) + creep_of_chain(150.0, later);
            CHECK(rows.at(4.0) == Approx(exact).epsilon(2e-4));
            const double soon = 2.0 - std::stod(jump);
            CHECK(rows.at(2.0) ==
                  Approx(creep_of_chain(100.0, 2.0) + creep_of_chain(150.0, soon)).epsilon(1e-3));
        }
    }
}

TEST_CASE("A stretch that comes at once strains a clamped relaxing rod at once", "[issues]") {
    // Clamped at both ends, −EA_0 ε at 0+, relaxed by the chain.
    const std::string deck = replaced(make_creep("0"), "[[load]]", R"([[actuation]]
on = "b"
stretch = 1e-3
[[support]]
at = "b.end"
fix = "all"
[[load]]
factor = 0)");
    const std::string with_force = replaced(replaced(deck,
                                                     "at = \"b.end\"\nquantities = [\"rotation_vector\"]",
                                                     "at = \"b@0.4\"\nquantities = [\"force\"]"),
                                            "[[load]]\nfactor = 0\nat = \"b.end\"\nmoment = [0, 0, 0]\n",
                                            "");
    const Rows rows = trace(with_force, "end", "force", 0).rows;
    const auto exact = [](double t) {
        return -1e6 * 1e-3 * (1.0 + 1.5 * std::exp(-t / 0.4) + 0.5 * std::exp(-t / 3.0));
    };
    for (const double t : {0.0, 0.1, 0.5, 4.0}) CHECK(rows.at(t) == Approx(exact(t)).epsilon(1e-9));
}

TEST_CASE("Weight that acts at once is that of statics", "[issues]") {
    const Trace quasi = trace(bar + clamped + at_once, "tip", "displacement", 2);
    CHECK(quasi.rows.at(0.0) == Approx(-0.1244578643).epsilon(1e-8));
    CHECK(quasi.rows.at(0.5) == Approx(-0.1244578643).epsilon(1e-8));
    CHECK(trace(bar + clamped + at_once, "tip", "displacement", 0).rows.at(0.5) ==
          Approx(-0.0088015842).epsilon(1e-7));
    // Weight falls by more than the rod stores: the rest is dissipated.
    CHECK(quasi.ledger.dissipated_energy == Approx(0.5 * quasi.ledger.external_work).epsilon(0.02));
    CHECK(std::abs(quasi.ledger.energy_error) < 1e-9 * quasi.ledger.external_work);
}

TEST_CASE("A slender rod under a small load at once needs no shorter steps", "[issues]") {
    const std::string deck = R"([section.s]
stiffness = { EA = 1e5, GAy = 1e5, GAz = 1e5, GJ = 10, EIy = 10, EIz = 10 }
[rod.b]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 2
[[support]]
at = "b.start"
fix = "all"
[[load]]
at = "b.end"
force = [0, FORCE, 0]
[analysis]
kind = "quasi-static"
end_time = 4
steps = 4
[[history]]
name = "tip"
at = "b.end"
quantities = ["displacement"]
)";
    const Rows at_once = trace(replaced(deck, "FORCE", "1"), "tip", "displacement", 1).rows;
    CHECK(at_once.at(0.0) == Approx(0.0333053).epsilon(2e-6));
    CHECK(at_once.at(4.0) == Approx(0.0333053).epsilon(2e-6));
    // Steps as large as that, with nothing at once.
    const Rows ramp = trace(replaced(deck, "FORCE", "\"t/4 + sin(pi*t/4)\""), "tip", "displacement", 1).rows;
    CHECK(ramp.at(4.0) == Approx(0.0333053).epsilon(2e-6));
}

TEST_CASE("Without inertia a moved support feels no mass", "[issues]") {
    const std::string moved = replaced(bar, "gravity = [0, 0, -1]\n", "") +
                              "[[support]]\nat = \"beam.start\"\nfix = [\"x\", \"y\", \"rotation\"]\n"
                              "move = { z = \"0.1*sin(2*pi*t)^2\" }\n"
                              "[[history]]\nname = \"root\"\nat = \"beam.start\"\n"
                              "quantities = [\"reaction_force\"]\n" +
                              replaced(at_once, "end_time = 0.5", "end_time = 0.25");
    const std::string order = GENERATE("1", "2", "3");
    for (const auto& [time, force] :
         trace(moved, "root", "reaction_force", 2, {"rod.beam.order=" + order}).rows)
        CHECK(std::abs(force) < 1e-8);
    for (const auto& [time, turn] :
         trace(moved, "tip", "rotation_vector", 1, {"rod.beam.order=" + order}).rows)
        CHECK(std::abs(turn) < 1e-10);
    // Nor does a body with added mass beside its node, on a support that turns.
    const std::string wet = R"(gravity = [0, 0, 0]
[fluid]
density = 1000
[body.ball]
mass = 3
inertia = [1, 1, 1]
at = [0, 0, -50]
fluid = { volume = 0.01, centre_of_buoyancy = [0.5, 0, 0], added_mass = [40, 40, 40] }
[[support]]
at = "ball"
fix = ["position", "rx", "ry"]
move = { rz = "3*t^2" }
[[history]]
name = "hub"
at = "ball"
quantities = ["reaction_force"]
[analysis]
kind = "quasi-static"
end_time = 1
steps = 10
)";
    for (const int axis : {0, 1}) {
        for (const auto& [time, force] : trace(wet, "hub", "reaction_force", axis).rows)
            CHECK(std::abs(force) < 1e-9);
    }
}

TEST_CASE("A stage in which nothing happens is silent", "[issues]") {
    const std::string stages =
        "[[stage]]\nname = \"load\"\nkind = \"static\"\nsteps = 1\n"
        "[[stage]]\nname = \"hold\"\nkind = \"quasi-static\"\nend_time = 4.0\nsteps = 40\n";
    std::string deck = make_creep("100", "");
    deck = deck.substr(0, deck.find("[analysis]")) + stages;
    DeckRun run("deck", deck, {});
    double first = 0.0, last = 0.0;
    run.run([&] {
        if (run.stage() == "hold" && first == 0.0) first = run.value("end", "rotation_vector")[2];
        last = run.value("end", "rotation_vector")[2];
    });
    CHECK(last == Approx(0.1).epsilon(1e-9));
    CHECK(first == Approx(last).epsilon(1e-13));
}

TEST_CASE("A static stage dissipates what a motion before it leaves", "[issues]") {
    const std::string stages =
        clamped +
        "[[stage]]\nname = \"swing\"\nkind = \"dynamic\"\nend_time = 0.25\ntime_step = 0.01\n"
        "[[stage]]\nname = \"rest\"\nkind = \"static\"\nsteps = 5\n";
    const Trace rest = trace(bar + stages, "tip", "displacement", 2);
    CHECK(rest.rows.rbegin()->second == Approx(-0.1244578643).epsilon(1e-7));
    CHECK(std::abs(rest.ledger.energy_error) < 1e-3 * rest.ledger.external_work);
    CHECK(rest.ledger.dissipated_energy > 0.1 * rest.ledger.external_work);
}

TEST_CASE("A stage that cannot start ends the run at the end of the one before", "[issues]") {
    const std::string deck = bar + R"([joint.knee]
type = "hinge"
between = ["ground", "beam.start"]
axis = [0, 1, 0]
move = "0.5*t - 0.5*t^2"
[[stage]]
name = "hang"
kind = "static"
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 0.25
time_step = 0.01
)";
    const sample::ScratchFolder folder;
    const RunSummary summary = run_problem(read(deck), folder / "run.vtkhdf");
    CHECK(summary.status == RunStatus::failed);
    CHECK(summary.deck_fault);
    CHECK_THAT(summary.reason,
               Catch::StartsWith("stage swing: the initial velocities do not fit joint knee; nearest to"));
    CHECK(summary.totals.steps == 10);
    // What was computed stays, and a mended deck goes on from there.
    const RunSummary resumed =
        resume_problem(read(replaced(deck, "kind = \"dynamic\"", "kind = \"dynamic\"\nstart = \"project\"")),
                       folder / "run.vtkhdf");
    CHECK(resumed.status == RunStatus::complete);
    CHECK(resumed.totals.steps == 35);
    // A motor that would have to jump, and a support.
    const RunSummary turned = run_problem(read(replaced(deck, "0.5*t - 0.5*t^2", "0.5*t")));
    CHECK(turned.deck_fault);
    CHECK_THAT(turned.reason, Catch::StartsWith("stage swing: joint knee begins with a jump of 0.5 of"));
    const RunSummary jump = run_problem(
        read(bar + clamped + "[[stage]]\nname = \"hang\"\nkind = \"static\"\n[[stage]]\nname = \"move\"\n" +
             "kind = \"quasi-static\"\nend_time = 1\nsteps = 4\n[[support]]\nat = \"beam.end\"\n" +
             "fix = [\"x\", \"y\"]\nmove = { z = \"0.3 + t\" }\nstages = [\"move\"]\n"));
    CHECK(jump.status == RunStatus::failed);
    CHECK_THAT(jump.reason, Catch::StartsWith("stage move: the support at beam.end begins with a jump"));
}

TEST_CASE("Motors that go on from stage to stage need no velocities that fit to the last digit", "[issues]") {
    const std::string deck = bar + R"([joint.knee]
type = "hinge"
between = ["ground", "beam.start"]
axis = [0, 1, 0]
move = "0.3*sin(4*pi*t)^2"
[[stage]]
name = "one"
kind = "KIND"
end_time = 0.5
time_step = 0.05
[[stage]]
name = "two"
kind = "dynamic"
integrator = "SCHEME"
end_time = 0.2
time_step = 0.05
)";
    const std::string scheme = GENERATE("newmark-simplified", "sdirk-4", "radau-5");
    const std::string kind = GENERATE("dynamic", "quasi-static");
    INFO(scheme << " after " << kind);
    // A rate of 0 where both stages begin, of the deck and of the second one alone.
    const RunSummary smooth = run_problem(read(replaced(replaced(deck, "KIND", kind), "SCHEME", scheme)));
    CHECK(smooth.reason == "");
}

TEST_CASE("A motion after steady rotation begins without false notes", "[issues]") {
    const std::string rotation = "[rotation]\naxis = [0, 0, 1]\nspeed = 10\n";
    const std::string blade = R"deck([section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 0.8, EIy = 1, EIz = 4 }
inertia = { rhoA = 1, rhoJ = 5e-4, rhoIy = 1e-4, rhoIz = 4e-4 }
[rod.blade]
section = "s"
line = { from = [0.2, 0, 0], to = [1.2, 0, 0] }
y_axis = [0, 1, 0]
elements = 6
order = 2
[[support]]
at = "blade.start"
fix = "all"
stages = ["turn"]
[[support]]
at = "blade.start"
fix = ["z", "rx", "ry"]
move = { x = "0.2*cos(10*t) - 0.2", y = "0.2*sin(10*t)", rz = "10*t" }
stages = ["go"]
[[stage]]
name = "turn"
kind = "steady"
steps = 4
[[stage]]
name = "go"
kind = "dynamic"
end_time = 0.1
steps = 20
integrator = "sdirk-4"
)deck";
    const Problem problem = read(rotation + blade);
    for (const Finding& finding : examine_stages(problem.model, problem.stages))
        CHECK_THAT(finding.message, !Catch::Contains("blow"));
    const RunSummary summary = run_problem(problem);
    CHECK(summary.reason == "");
    CHECK(summary.notes.empty());
    // At rest before, the start is a blow as it was.
    const Problem at_rest = read(replaced(blade, "kind = \"steady\"", "kind = \"static\""));
    bool is_blow = false;
    for (const Finding& finding : examine_stages(at_rest.model, at_rest.stages))
        is_blow = is_blow || finding.message.find("the start is a blow") != std::string::npos;
    CHECK(is_blow);
}

TEST_CASE("A static stage lets go in parts of what a motion that yields leaves", "[issues]") {
    const std::string deck = R"(gravity = [0, 0, -120]
[section.s]
shape = { rectangle = { width_y = 0.05, height_z = 0.05 } }
material = { E = 2e5, nu = 0.3, density = 1, yield_stress = 3000 }
[rod.b]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 2
[[support]]
at = "b.start"
fix = "all"
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 0.2
time_step = 0.002
[[stage]]
name = "rest"
kind = "static"
steps = 4
)";
    const std::string gravity = GENERATE("-120", "-300");
    const RunSummary summary = run_problem(read(replaced(deck, "-120", gravity)));
    CHECK(summary.reason == "");
    CHECK(summary.status == RunStatus::complete);
}

TEST_CASE("The energy of a spring counts a kink close to its length", "[issues]") {
    // ½ k s² of a stop at 1.05, touched by s, from 1.1 on.
    const SpringLaw stop(
        [](double length, double) { return length < 1.05 ? 2e6 * (length - 1.05) : 0.0; }, false, 1.1);
    for (const double s : {1e-7, 1e-5, 2e-4, 4e-4, 1e-2})
        CHECK(compute_law_energy(stop, 1.05 - s) == Approx(1e6 * s * s).epsilon(1e-6));
    CHECK(compute_law_energy(stop, 1.06) == 0.0);
    // The other way round, and a force that jumps.
    const SpringLaw slack([](double length, double) { return length > 2.0 ? 5.0 : 0.0; }, false, 1.0);
    for (const double s : {1e-6, 1e-3, 0.5})
        CHECK(compute_law_energy(slack, 2.0 + s) == Approx(5.0 * s).epsilon(1e-9));
}

TEST_CASE("Still water lets nothing go at once, and a rod in it creeps to its equilibrium", "[issues]") {
    const auto deck = [](const std::string& analysis) {
        return R"(gravity = [0, 0, -1]
[section.bar]
stiffness = { EA = 1e3, GAy = 500, GAz = 500, GJ = 1, EIy = 1, EIz = 1.5 }
inertia = { rhoA = 1, rhoJ = 0.02, rhoIy = 0.01, rhoIz = 0.01 }
fluid = { outer_diameter = 0.04 }
[rod.beam]
section = "bar"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 6
order = 2
y_axis = [0, 1, 0]
[[support]]
at = "beam.start"
fix = "all"
[[load]]
at = "beam.end"
force = [0, 0.1, 0.05]
[fluid]
density = 100
[[history]]
name = "tip"
at = "beam.end"
quantities = ["displacement"]
[[history]]
name = "middle"
at = "beam@0.5"
quantities = ["displacement"]
[analysis]
newton = { tolerance = 1e-10 }
)" + analysis;
    };
    const Rows creep =
        trace(deck("kind = \"quasi-static\"\nend_time = 3.0\nsteps = 60\n"), "tip", "displacement", 2).rows;
    const double end = trace(deck("kind = \"static\"\n"), "tip", "displacement", 2).rows.rbegin()->second;
    CHECK(end < -0.05);
    CHECK(std::abs(creep.at(0.0)) < 1e-3 * std::abs(end));
    CHECK(creep.at(3.0) == Approx(end).epsilon(1e-4));
    for (auto row = std::next(creep.begin()); row != creep.end(); ++row)
        CHECK(row->second <= std::prev(row)->second + 1e-3 * std::abs(end));
    // Far from its ends it begins to move across at the speed at which drag is its weight in water,
    // ½ 100 0.04 v² = 1 − 100 π 0.02².
    const double start =
        trace(deck("kind = \"quasi-static\"\nend_time = 0.001\nsteps = 40\n"), "middle", "displacement", 2)
            .rows.at(0.001);
    CHECK(start / 0.001 == Approx(-std::sqrt(0.8743 / 2.0)).epsilon(0.05));
}

TEST_CASE("Actuation that comes at once slips in a law as one that grows", "[issues]") {
    const auto deck = [](const std::string& factor, const std::string& analysis) {
        return fmt::format(R"(gravity = [0, 0, "-1*{0}"]
[section.bar]
stiffness = {{ EA = 1e3, GAy = 500, GAz = 500, GJ = 1, EIy = 1, EIz = 1.5 }}
law = {{ layers = [{{ on = "bending", stiffness = 0.5, limit = 0.13 }}] }}
inertia = {{ rhoA = 1, rhoJ = 0.02, rhoIy = 0.01, rhoIz = 0.01 }}
[rod.beam]
section = "bar"
line = {{ from = [0, 0, 0], to = [1, 0, 0] }}
elements = 6
order = 2
y_axis = [0, 1, 0]
[[support]]
at = "beam.start"
fix = "all"
[[actuation]]
on = "beam"
curvature = ["0.2*{0}", "-0.35*{0}", "0.3*s*{0}"]
[[history]]
name = "tip"
at = "beam.end"
quantities = ["displacement"]
[analysis]
newton = {{ tolerance = 1e-10 }}
{1})",
                           factor,
                           analysis);
    };
    const auto end_of = [](const std::string& text) {
        return trace(text, "tip", "displacement", 2).rows.rbegin()->second;
    };
    const double grown = end_of(deck("1", "kind = \"static\"\nsteps = 20"));
    CHECK(grown > 0.05);
    CHECK(end_of(deck("1", "kind = \"quasi-static\"\nend_time = 1.0\nsteps = 10")) ==
          Approx(grown).epsilon(1e-3));
    CHECK(end_of(deck("t", "kind = \"quasi-static\"\nend_time = 1.0\nsteps = 20")) ==
          Approx(grown).epsilon(1e-5));
}

}  // namespace gxrod::test
