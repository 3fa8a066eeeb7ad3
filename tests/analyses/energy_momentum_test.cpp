// Energy and momenta of rods under the scheme energy-momentum: constant where nothing acts, and else as work
// and impulses change them.
#include "check/failure_advice.hpp"
#include "deck/decks.hpp"
#include "solvers/conservation.hpp"
#include "tools/catch.hpp"
#include "tools/free_flight.hpp"
#include "tools/run.hpp"

using namespace gxrod;
using namespace gxrod::test;
using namespace gxrod::tools;

namespace {

// Tumbles, bends, twists and stretches.
const std::string tumbling = R"([section.s]
stiffness = { EA = 1e3, GAy = 5e2, GAz = 5e2, GJ = 0.8, EIy = 1, EIz = 2 }
inertia = { rhoA = 1.0, rhoJ = 3e-3, rhoIy = 1e-3, rhoIz = 2e-3 }
[rod.r]
section = "s"
line = { from = [-0.5, 0, 0], to = [0.5, 0, 0] }
y_axis = [0, 1, 0]
elements = 3
order = 2
[[initial]]
on = "r"
velocity = [0.3, "2*x + x^2 - 1/12", "3*x^3"]
angular_velocity = [4, 0, "2 + 2*x"]
[analysis]
kind = "dynamic"
integrator = "energy-momentum"
end_time = 1.0
time_step = 0.005
)";

Problem make_tumbling(const std::string& end_time, const std::string& time_step) {
    return read(tumbling, {"analysis.end_time=" + end_time, "analysis.time_step=" + time_step});
}

// The largest deviation of a run from the energy and the momenta of its start.
struct Drift {
    double energy = 0.0;
    double linear = 0.0;
    double angular = 0.0;
};

Drift measure_drift(const Problem& problem) {
    DynamicAnalysis analysis(problem.model, dynamic_of(problem));
    REQUIRE(analysis.start().converged());
    const LedgerRow first = analysis.ledger_row();
    Drift drift;
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        const LedgerRow row = analysis.ledger_row();
        const double change =
            row.kinetic_energy + row.strain_energy - first.kinetic_energy - first.strain_energy;
        drift.energy = std::max(drift.energy, std::abs(change));
        drift.linear = std::max(drift.linear, (row.linear_momentum - first.linear_momentum).norm());
        drift.angular = std::max(drift.angular, (row.angular_momentum - first.angular_momentum).norm());
    }
    return drift;
}

// The end of a rod that a smooth load has driven for 2 s.
Vec3 find_end(Scheme scheme, long steps) {
    Model model = make_free_flight(4);
    model.rods[0].kind = ElementKind::objective;
    return run_to_end(model, make_settings(scheme, 2.0, steps)).r;
}

}  // namespace

TEST_CASE("energy-momentum keeps energy and momenta of a free rod over 10,000 steps", "[analyses]") {
    const Drift drift = measure_drift(make_tumbling("50", "0.005"));
    // Energy and momenta are 0.3, 0.3 and 0.2; round-off of each step adds up.
    CHECK(drift.energy < 1e-12);
    CHECK(drift.linear < 1e-13);
    CHECK(drift.angular < 1e-12);
}

TEST_CASE("energy-momentum keeps them with long steps and steps by their error", "[analyses]") {
    for (const char* key : {"analysis.time_step=0.02", "analysis.adaptive={ tolerance = 1e-3 }"}) {
        INFO(key);
        const Drift drift = measure_drift(read(tumbling, {"analysis.end_time=0.5", key}));
        CHECK(drift.energy < 1e-14);
        CHECK(drift.linear < 1e-14);
        CHECK(drift.angular < 1e-14);
    }
}

TEST_CASE("energy-momentum is of order 2", "[analyses]") {
    const Vec3 exact = find_end(Scheme::radau_5, 400);
    std::vector<double> errors;
    for (const long steps : {100L, 200L, 400L})
        errors.push_back((find_end(Scheme::energy_momentum, steps) - exact).norm());
    for (const double order : compute_orders(errors)) CHECK(order == Approx(2.0).margin(0.2));
}

TEST_CASE("under loads energy and momenta follow work and impulses", "[analyses]") {
    // From rest, where there is no energy yet.
    const Model model = make_free_flight(4);
    DynamicSettings settings = make_settings(Scheme::energy_momentum, 8.0, 80);
    LedgerRow last;
    double worst = 0.0;
    run(model, settings, [&](const DynamicAnalysis& analysis) {
        last = analysis.ledger_row();
        worst = std::max(worst, std::abs(last.energy_error));
    });
    CHECK(last.kinetic_energy > 500.0);
    CHECK(worst < 1e-12 * last.kinetic_energy);
    // The impulse of the pulse's force, by the trapezoidal rule, which integrates sin² exactly.
    CHECK((last.linear_momentum - Vec3(50.0, 0.0, 0.0)).norm() < 1e-11);
}

TEST_CASE("in a field of gravity a rod falls freely, and its energy stays", "[analyses]") {
    const Problem problem = read("gravity = [0, 0, -9.81]\n" + tumbling);
    double worst = 0.0;
    LedgerRow last;
    run(problem.model, dynamic_of(problem), [&](const DynamicAnalysis& analysis) {
        last = analysis.ledger_row();
        worst = std::max(worst, std::abs(last.energy_error));
    });
    CHECK(worst < 1e-12 * last.kinetic_energy);
    CHECK((last.linear_momentum - Vec3(0.3, 0.0, -9.81)).norm() < 1e-12);
}

TEST_CASE("a rod at rest stays at rest under energy-momentum", "[analyses]") {
    const Problem problem = read(rod_deck + "integrator = \"energy-momentum\"");
    const NodeMotion last = run_to_end(problem.model, dynamic_of(problem));
    CHECK(last.r == Vec3::Zero());
    CHECK(last.v == Vec3::Zero());
}

namespace {

const std::string bar = R"([section.s]
stiffness = { EA = 1e3, GAy = 5e2, GAz = 5e2, GJ = 0.8, EIy = 1, EIz = 2 }
inertia = { rhoA = 1.0, rhoJ = 3e-3, rhoIy = 1e-3, rhoIz = 2e-3 }
)";
const std::string arm = R"([rod.r]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 4
order = 2
)";
const std::string motion = R"([analysis]
kind = "dynamic"
integrator = "energy-momentum"
end_time = 2.0
time_step = 0.01
)";
const std::string clamp = "[[support]]\nat = \"r.start\"\nfix = \"all\"\n";
const std::string blow = "[[initial]]\non = \"r\"\nvelocity = [0, \"0.3*x^2\", \"-0.5*x^2\"]\n";

// The largest error of the ledger in a run, relative to the largest kinetic energy.
double measure_error(const Problem& problem) {
    double worst = 0.0, largest = 0.0;
    DynamicAnalysis analysis(problem.model, dynamic_of(problem));
    REQUIRE(analysis.start().converged());
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        const LedgerRow row = analysis.ledger_row();
        worst = std::max(worst, std::abs(row.energy_error));
        largest = std::max(largest, row.kinetic_energy);
    }
    CHECK(largest > 1e-3);
    return worst / largest;
}

}  // namespace

TEST_CASE("energy-momentum balances the energy of what is held, jointed, damped, driven", "[analyses]") {
    const std::string hinge =
        "[joint.root]\ntype = \"hinge\"\nbetween = [\"ground\", \"r.start\"]\naxis = [0, 1, 0]\n";
    const std::string knee = R"([rod.q]
section = "s"
line = { from = [1, 0, 0], to = [1.5, 0, 0] }
elements = 2
[joint.knee]
type = "universal"
between = ["r.end", "q.start"]
axis = [0, 1, 0]
axis_b = [0, 0, 1]
)";
    const std::string weight = "gravity = [0, 0, -9.81]\n";
    const std::string damped = "[section.s.damping]\nkelvin_voigt = 0.02\nmass_proportional = 0.1\n";
    const std::string plastic = "[section.s.law.plastic]\nyield = { My = 0.2, Mz = 0.2 }\nkinematic = 0.5\n";
    const std::string pull = "[tendon.pull]\non = \"r\"\noffset = [0, 0.05]\ntension = \"sin(3*t)\"\n";
    const std::string wind =
        "[section.s.fluid]\nouter_diameter = 0.2\n[air]\ndensity = 1.2\n[air.wind]\nvelocity = [0, 3, 0]\n";
    const std::string rate = "[[load]]\nat = \"r.end\"\nforce = [0, \"-0.3*vy\", \"-2*z\"]\n";
    for (const std::string& deck : {bar + arm + clamp + blow + motion,
                                    weight + bar + arm + hinge + motion,
                                    weight + bar + arm + knee + hinge + motion,
                                    bar + arm + knee + blow + motion + "start = \"project\"\n",
                                    bar + damped + arm + clamp + blow + motion,
                                    bar + plastic + arm + clamp + blow + motion,
                                    bar + arm + clamp + pull + motion,
                                    bar + arm + clamp + blow + wind + motion,
                                    bar + arm + clamp + blow + rate + motion}) {
        INFO(deck);
        CHECK(measure_error(read(deck)) < 1e-11);
        CHECK(measure_error(read(replaced(deck, "energy-momentum", "newmark-simplified"))) > 1e-7);
    }
}

TEST_CASE("energy-momentum keeps momenta in a plane and of what joints join", "[analyses]") {
    // A free rod in its plane, and two rods with a knee between them.
    const std::string planar =
        "plane = \"xy\"\n" + bar + arm +
        "[[initial]]\non = \"r\"\nvelocity = [0.2, \"x^2\", 0]\nangular_velocity = [0, 0, 1]\n" + motion;
    const Drift drift = measure_drift(read(planar));
    CHECK(drift.energy < 1e-13);
    CHECK(drift.linear < 1e-13);
    CHECK(drift.angular < 1e-13);
    const std::string jointed = bar + arm + R"([rod.q]
section = "s"
line = { from = [1, 0, 0], to = [1.5, 0, 0] }
elements = 2
[joint.knee]
type = "ball"
between = ["r.end", "q.start"]
[[initial]]
on = "r"
velocity = [0.2, "x^2", "0.5*x"]
[[initial]]
on = "q"
velocity = [0.2, "1", "0.5"]
)" + motion;
    const Drift of_two = measure_drift(read(jointed));
    CHECK(of_two.energy < 1e-12);
    CHECK(of_two.linear < 1e-12);
    CHECK(of_two.angular < 1e-12);
}

TEST_CASE("energy-momentum of what is held is of order 2", "[analyses]") {
    const auto end = [](const std::string& scheme, const char* step) {
        const Problem problem = read("gravity = [0, 0, -3]\n" + bar + arm + clamp + blow + motion,
                                     {"analysis.end_time=0.2",
                                      "analysis.integrator=" + scheme,
                                      std::string("analysis.time_step=") + step});
        Vec3 place;
        run(problem.model, dynamic_of(problem), [&](const DynamicAnalysis& analysis) {
            place = analysis.state().trial.back().r;
        });
        return place;
    };
    const Vec3 exact = end("radau-5", "2e-4");
    std::vector<double> errors;
    for (const char* step : {"1e-4", "5e-5", "2.5e-5"})
        errors.push_back((end("energy-momentum", step) - exact).norm());
    for (const double order : compute_orders(errors)) CHECK(order == Approx(2.0).margin(0.25));
}

TEST_CASE("rates that balance are left as they are, and the others moved the least", "[analyses]") {
    const Problem problem = make_tumbling("1", "0.005");
    const System system(problem.model);
    State state = system.initial_state();
    const std::vector<NodeMotion> before = state.trial;
    const Stage stage{0, 0.0, 0.005, 0.005};
    StepStart start = note_step_start(system, state, 0.0);
    EquilibriumReport report;
    conserve(system, start, stage, 0.0, state, report);
    REQUIRE(report.converged());
    for (std::size_t i = 0; i < before.size(); ++i) {
        CHECK((state.trial[i].v - before[i].v).norm() < 1e-13);
        CHECK((state.trial[i].omega - before[i].omega).norm() < 1e-13);
    }
    // All have one more velocity: the change is that velocity, and its kinetic energy ½ m v².
    const Vec3 more(0.01, -0.02, 0.03);
    start.momentum.linear += more;
    const double along = start.momentum.linear.dot(more) - 0.5 * more.squaredNorm();
    conserve(system, start, stage, -along, state, report);
    REQUIRE(report.converged());
    for (std::size_t i = 0; i < before.size(); ++i) {
        CHECK((state.trial[i].v - before[i].v - more).norm() < 1e-13);
        CHECK((state.trial[i].omega - before[i].omega).norm() < 1e-13);
    }
    // Energy that vibrations do not have.
    conserve(system, start, stage, 0.1, state, report);
    CHECK(report.outcome == Outcome::energy_out_of_reach);
}

namespace {

// The rod, thrown with velocities that are zero at its start, which is held.
Problem make_held(const std::string& holds, const std::string& gravity = "", const std::string& end = "5") {
    std::string deck = replaced(tumbling, "[analysis]", holds + "[analysis]\nstart = \"project\"");
    deck = replaced(deck,
                    "velocity = [0.3, \"2*x + x^2 - 1/12\", \"3*x^3\"]",
                    "velocity = [0, \"4*(x + 0.5)^2\", \"2*(x + 0.5)^2\"]");
    deck = replaced(deck,
                    "angular_velocity = [4, 0, \"2 + 2*x\"]",
                    "angular_velocity = [0, \"-4*(x + 0.5)\", \"8*(x + 0.5)\"]");
    return read(gravity + deck, {"analysis.end_time=" + end});
}

std::string support(const std::string& fix) { return "[[support]]\nat = \"r.start\"\nfix = " + fix + "\n"; }

// The largest changes of the energy, and of the momenta along chosen axes, of angular ones about the pin.
Drift measure_held(const Problem& problem, const Vec3& linear, const Vec3& angular) {
    DynamicAnalysis analysis(problem.model, dynamic_of(problem));
    REQUIRE(analysis.start().converged());
    const LedgerRow first = analysis.ledger_row();
    CHECK(first.kinetic_energy > 0.1);
    const Vec3 pin(-0.5, 0.0, 0.0);
    Drift drift;
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        const LedgerRow row = analysis.ledger_row();
        const double energy =
            row.kinetic_energy + row.strain_energy - first.kinetic_energy - first.strain_energy;
        const Vec3 more = row.linear_momentum - first.linear_momentum;
        const Vec3 turn = row.angular_momentum - first.angular_momentum - pin.cross(more);
        drift.energy = std::max(drift.energy, std::abs(energy));
        drift.linear = std::max(drift.linear, more.cwiseProduct(linear).norm());
        drift.angular = std::max(drift.angular, turn.cwiseProduct(angular).norm());
    }
    return drift;
}

}  // namespace

TEST_CASE("energy-momentum keeps the energy of held rods, and momenta along what is free", "[analyses]") {
    struct Case {
        std::string holds;
        Vec3 linear, angular;  // 1 along axes that keep their momenta
    };
    for (const Case& one : {Case{support("\"all\""), {0, 0, 0}, {0, 0, 0}},
                            Case{support("\"position\""), {0, 0, 0}, {1, 1, 1}},
                            Case{support("[\"position\", \"rx\", \"ry\"]"), {0, 0, 0}, {0, 0, 1}},
                            Case{support("[\"x\", \"z\"]"), {0, 1, 0}, {0, 1, 0}},
                            Case{support("[\"z\"]"), {1, 1, 0}, {0, 0, 1}}}) {
        INFO(one.holds);
        const Drift drift = measure_held(make_held(one.holds), one.linear, one.angular);
        CHECK(drift.energy < 2e-11);
        CHECK(drift.linear < 1e-12);
        CHECK(drift.angular < 2e-12);
    }
    const Problem falling = make_held(support("\"position\""), "gravity = [0, -9.81, 0]\n");
    double worst = 0.0;
    run(falling.model, dynamic_of(falling), [&](const DynamicAnalysis& analysis) {
        worst = std::max(worst, std::abs(analysis.ledger_row().energy_error));
    });
    CHECK(worst < 1e-11);
}

TEST_CASE("energy-momentum keeps energy and momenta of rods with joints", "[analyses]") {
    const std::string second =
        "[rod.q]\nsection = \"s\"\nline = { from = [0.5, 0, 0], to = [0.5, 0.7, 0] }\nelements = 2\n"
        "[joint.knee]\nbetween = [\"r.end\", \"q.start\"]\n";
    for (const std::string kind : {"type = \"ball\"\n", "type = \"hinge\"\naxis = [0, 0, 1]\n"}) {
        INFO(kind);
        const Drift free = measure_held(make_held(second + kind), {1, 1, 1}, {1, 1, 1});
        CHECK(free.energy < 1e-11);
        CHECK(free.linear < 1e-12);
        CHECK(free.angular < 1e-11);
        CHECK(measure_held(make_held(support("\"all\"") + second + kind), {0, 0, 0}, {0, 0, 0}).energy <
              1e-11);
    }
    const std::string root = "[joint.root]\ntype = \"ball\"\nbetween = [\"ground\", \"r.start\"]\n";
    CHECK(measure_held(make_held(root), {0, 0, 0}, {0, 0, 0}).energy < 1e-11);
}

TEST_CASE("a step whose energy is out of reach says so, and what to do", "[analyses]") {
    Failure failure;
    failure.outcome = Outcome::energy_out_of_reach;
    CHECK(describe_failure(failure).ends_with(
        "the energy of the step is off by more than the vibrations of the model can take up. Try a smaller "
        "time_step; or integrator = \"gauss-4\", where a model turns almost without vibrating"));
}
