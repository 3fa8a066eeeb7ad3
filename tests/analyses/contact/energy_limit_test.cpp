// Where rods touch, no step gains energy: what the scheme would give is taken from its vibrations.
#include "solvers/energy_limit.hpp"

#include "analyses/contact/contact_run.hpp"
#include "assembly/system_measures.hpp"
#include "tools/problem_run.hpp"

namespace gxrod::test {
namespace {

const std::string section = R"([section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e7, nu = 0.3, density = 1000 }
)";

// Bends slowly and, a tenth as fast, in a wave of two elements.
const std::string bending = section + rod("r", "0, 0, 0", "1, 0, 0", 10) + R"deck([[initial]]
on = "r"
velocity = [0.3, "sin(pi*x)", "0.1*sin(10*pi*x)"]
angular_velocity = [0.2, 0, 0]
[analysis]
kind = "dynamic"
end_time = 1
time_step = 1e-3
)deck";

struct Taken {
    double energy = 0.0, surplus = 0.0;
    LedgerRow before, after;
    State state;
};

// Takes this part of the kinetic energy of a deck's start.
Taken take(const std::string& deck, double part) {
    const Problem problem = read(deck);
    const System system(problem.model);
    Taken taken;
    taken.state = system.initial_state();
    SolverWorkspace workspace(system, LinearSolverKind::automatic);
    const auto measure = [&](LedgerRow& row) {
        const Balance balance = SystemMeasures(system).compute_balance(taken.state, 0.0);
        row.kinetic_energy = balance.kinetic_energy;
        row.linear_momentum = balance.momentum.linear;
        row.angular_momentum = balance.momentum.angular;
    };
    measure(taken.before);
    taken.surplus = part * taken.before.kinetic_energy;
    taken.energy = take_surplus(system, {0, 0.0, 1e-3, 1e-3}, taken.surplus, workspace, taken.state);
    measure(taken.after);
    return taken;
}

// The amplitude of a velocity's wave along the rod, from its nodes.
double find_wave(const State& state, int component, double number) {
    double along = 0.0, whole = 0.0;
    for (const NodeMotion& motion : state.trial) {
        const double wave = std::sin(number * motion.r.x() * 3.14159265358979);
        along += motion.v[component] * wave;
        whole += wave * wave;
    }
    return along / whole;
}

}  // namespace

TEST_CASE("A surplus of energy is taken from fast vibrations first, without momentum", "[analyses][touch]") {
    const Taken taken = take(bending, 5e-3);
    CHECK(taken.energy >= taken.surplus);
    CHECK(taken.energy <= 1.25 * taken.surplus);
    CHECK(taken.before.kinetic_energy - taken.after.kinetic_energy == Approx(taken.energy).epsilon(1e-9));
    CHECK((taken.after.linear_momentum - taken.before.linear_momentum).norm() <
          1e-12 * taken.before.linear_momentum.norm());
    CHECK((taken.after.angular_momentum - taken.before.angular_momentum).norm() <
          1e-12 * taken.before.linear_momentum.norm());
    CHECK(find_wave(taken.state, 1, 1.0) > 0.995);
    CHECK(std::abs(find_wave(taken.state, 2, 10.0)) < 0.06);
}

TEST_CASE("What vibrations do not have is taken from all that moves, a tenth at most", "[analyses][touch]") {
    const std::string rigid = section + rod("r", "0, 0, 0", "1, 0, 0", 4) +
                              "[[initial]]\non = \"r\"\nvelocity = [0, 0, 2]\n[analysis]\nkind = "
                              "\"dynamic\"\nend_time = 1\ntime_step = 1e-3\n";
    const Taken little = take(rigid, 0.01);
    CHECK(little.energy == Approx(little.surplus).epsilon(1e-9));
    for (const NodeMotion& motion : little.state.trial)
        CHECK(motion.v.z() == Approx(2.0 * std::sqrt(0.99)).epsilon(1e-9));
    const Taken much = take(rigid, 0.2);
    CHECK(much.energy == 0.0);
    for (const NodeMotion& motion : much.state.trial) CHECK(motion.v.z() == 2.0);
}

TEST_CASE("Supports and joints hold where a surplus is taken", "[analyses][touch]") {
    const std::string chain =
        section + rod("a", "0, 0, 0", "1, 0, 0", 5) + rod("b", "1, 0, 0", "2, 0, 0", 5) + R"deck([[support]]
at = "a.start"
fix = "all"
[joint.pin]
type = "hinge"
between = ["a.end", "b.start"]
axis = [0, 1, 0]
[[initial]]
on = ["a", "b"]
velocity = [0, 0, "x^2*sin(20*x)"]
[analysis]
kind = "dynamic"
end_time = 1
time_step = 1e-3
)deck";
    const Taken taken = take(chain, 0.2);
    CHECK(taken.energy >= taken.surplus);
    CHECK(taken.energy <= 1.25 * taken.surplus);
    const std::vector<NodeMotion>& nodes = taken.state.trial;
    CHECK(nodes.front().v == Vec3::Zero());
    CHECK(nodes.front().omega == Vec3::Zero());
    const std::size_t end_of_a = nodes.size() / 2 - 1;
    CHECK(nodes[end_of_a].v.norm() > 0.1);
    CHECK((nodes[end_of_a].v - nodes[end_of_a + 1].v).norm() < 1e-9);
}

TEST_CASE("What steps lose where something could touch falls with their square", "[analyses][touch]") {
    const std::string floor = "[obstacle.floor]\nplane = { point = [0, 0, -9], normal = [0, 0, 1] }\n";
    for (const char* scheme : {"newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha"}) {
        INFO(scheme);
        std::vector<double> losses;
        for (const char* step : {"1e-4", "5e-5", "2.5e-5"}) {
            ContactRun run(section + floor + rod("r", "0, 0, 0", "1, 0, 0", 4) +
                           fmt::format("[[initial]]\non = \"r\"\nvelocity = [0, \"x^2\", \"0.3*x^2\"]\n"
                                       "[analysis]\nkind = \"dynamic\"\nend_time = 0.02\n"
                                       "time_step = {}\nintegrator = \"{}\"\n",
                                       step,
                                       scheme));
            run.finish();
            const LedgerRow row = run.ledger();
            losses.push_back(row.numerical_dissipation);
            CHECK(row.energy_error >= 0.0);
            CHECK(row.energy_error <= 1e-4 * row.kinetic_energy);
        }
        CHECK(losses[0] > 0.0);
        CHECK(losses[1] < 0.4 * losses[0]);
        CHECK(losses[2] < 0.4 * losses[1]);
    }
}

TEST_CASE("Nothing is limited until something touches", "[analyses][touch]") {
    // A support that sets a rod off at once does work that the first steps do not resolve, next to which all
    // energy is small.
    ContactRun run(section + "[obstacle.floor]\nplane = { point = [0, 0, -0.5], normal = [0, 0, 1] }\n" +
                   rod("r", "0, 0, 0", "1, 0, 0", 10) + R"deck([[support]]
at = "r.start"
fix = ["y", "z", "rotation"]
move = { x = "t < 0.1 ? 0.5*t^2 : 0.1*t - 0.005" }
[analysis]
kind = "dynamic"
end_time = 0.05
time_step = 1e-3
gamma = 0.6
beta = 0.3
)deck");
    run.finish();
    CHECK(run.rejected() == 0);
    CHECK(run.ledger().energy_error == 0.0);
    CHECK(run.at("r.start").r.x() == Approx(0.5 * 0.05 * 0.05).epsilon(1e-12));
}

TEST_CASE("A motion after statics with contact gains nothing from the errors of load steps",
          "[analyses][touch]") {
    // A cantilever that bends to the floor in few steps, whose work the trapezoidal rule misses by much, and
    // then rests.
    const RunSummary summary = tools::run_problem(read(R"(
gravity = [0, 0, -1]
[section.s]
stiffness = { EA = 1000.0, GAy = 500.0, GAz = 500.0, GJ = 1.0, EIy = 1.0, EIz = 1.5 }
inertia = { rhoA = 1.0, rhoJ = 0.02, rhoIy = 0.01, rhoIz = 0.01 }
radius = 0.02
[obstacle.floor]
plane = { point = [0, 0, -0.07], normal = [0, 0, 1] }
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, 0.1, 0.05]
)" + rod("r", "0, 0, 0", "1, 0, 0", 6) + R"(
[[stage]]
name = "press"
kind = "static"
steps = 4
[[stage]]
name = "rest"
kind = "dynamic"
end_time = 0.25
steps = 25
)"));
    INFO(summary.reason);
    CHECK(summary.status == RunStatus::complete);
}

namespace {

// Without impulses what an impact loses is `numerical_dissipation`.
bool takes_impulses(const std::string& scheme) { return scheme != "sdirk-4" && scheme != "radau-5"; }

}  // namespace

TEST_CASE("Rods that vibrate after impacts gain no energy at any step", "[analyses][touch]") {
    // A steel-like rod that falls on a floor askew: what its scheme makes of the vibrations doubled its
    // energy.
    for (const char* scheme :
         {"newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4", "radau-5"}) {
        for (const double step : {3e-3, 1e-3, 3e-4}) {
            INFO(scheme << " " << step);
            ContactRun run(R"([section.s]
shape = { circle = { radius = 0.005 } }
material = { E = 6e9, nu = 0.4, density = 1100 }
[obstacle.floor]
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
)" + rod("r", "0, 0, 0.1", "0.2, 0.1, 0.25", 6) +
                           fmt::format("[[initial]]\non = \"r\"\nvelocity = [5, 0, -40]\n[analysis]\n"
                                       "kind = \"dynamic\"\nend_time = 0.03\ntime_step = {}\n"
                                       "integrator = \"{}\"\n",
                                       step,
                                       scheme));
            const double start = run.ledger().kinetic_energy;
            double least = start;
            while (!run.is_finished()) {
                run.step();
                const LedgerRow row = run.ledger();
                const double energy = row.kinetic_energy + row.strain_energy + row.contact_energy;
                CHECK(energy < least + 1.001e-4 * start);
                least = std::min(least, energy);
            }
            CHECK(run.least_gap() < 1e-4);  // the skin
            if (takes_impulses(scheme)) CHECK(run.ledger().contact_loss > 0.01 * start);
        }
    }
}

}  // namespace gxrod::test
