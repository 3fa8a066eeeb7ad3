
#include <array>
#include <thread>

#include "deck/decks.hpp"
#include "run/run.hpp"
#include "tools/catch.hpp"

// A run that several threads share, against the same run by one: equal to the last bit.

namespace gxrod::test {
namespace {

// Rods that share nodes, long enough for several parts of every loop; with what assembly treats apart: a
// body, `simo` elements, damping, a section with a law, tendons, loads along rods, a roller in its own axes
// and a support that moves.
const std::string structure = R"deck(gravity = [0, 0, "-9.81*cos(t)"]
[section.s]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 5e3, EIy = 6e3, EIz = 7e3 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[section.damped]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 5e3, EIy = 6e3, EIz = 7e3 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
damping = { kelvin_voigt = 1e-3, mass_proportional = 0.3 }
[rod.spine]
section = "s"
line = { from = [0, 0, 0], to = [8, 0, 0] }
elements = 900
[rod.branch]
section = "damped"
line = { from = [4, 0, 0], to = [4, 5, 0] }
elements = 500
[rod.leaf]
section = "damped"
element = "simo"
order = 2
line = { from = [4, 5, 0], to = [4, 5, 4] }
elements = 300
[rod.brace]
section = "s"
line = { from = [4, 5, 0], to = [8, 0, 0] }
elements = 300
order = 3
[section.limp]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 5e3, EIy = 6e3, EIz = 7e3 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
law = { viscoelastic = { prony = [[0.5, 0.1]] } }
[rod.limb]
section = "limp"
line = { from = [8, 0, 0], to = [8, 0, -3] }
elements = 200
[tendon.cord]
on = "limb"
offset = [0.02, "0.01*sin(s)"]
tension = "100*t"
[tendon.drawn]
on = "limb"
offset = [-0.02, 0]
shortening = "1e-3*t^2"
slack = false
to = 0.05
[[actuation]]
on = "limb"
curvature = [0, "0.1*t", 0]
[[connect]]
points = ["branch.start", "spine@0.5"]
[[connect]]
points = ["branch.end", "leaf.start", "brace.start"]
[[connect]]
points = ["brace.end", "spine.end", "limb.start"]
[body.b]
at = "leaf.end"
mass = 0.5
inertia = [0.1, 0.2, 0.2]
[[support]]
at = "spine.start"
fix = ["y", "z", "rx", "rz"]
move = { x = "0.1*sin(5*t)", ry = "0.2*t" }
[[support]]
at = "spine.end"
fix = ["z"]
axes = [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1]]
[[load]]
at = "leaf.end"
force = [0, "10*t", 0]
frame = "follower"
[[load]]
on = "branch"
force_per_length = [0, 0, "t*(1 + s)"]
frame = "body"
)deck";

struct Outcome {
    RunSummary summary;
    std::vector<NodeMotion> motions;
    std::vector<LedgerRow> ledger;
    std::vector<Vec6> reactions;
};

Outcome run(const std::string& analysis, int threads) {
    const Problem problem = read(structure + analysis);
    RunRequest request{problem};
    request.threads = threads;
    Outcome outcome;
    request.observe = [&](const Snapshot& snapshot, const LedgerRow& row) {
        outcome.motions.assign(snapshot.nodes.begin(), snapshot.nodes.end());
        outcome.reactions.assign(snapshot.reactions.begin(), snapshot.reactions.end());
        outcome.ledger.push_back(row);
    };
    outcome.summary = run_analysis(request);
    return outcome;
}

bool is_same(const NodeMotion& a, const NodeMotion& b) {
    return a.r == b.r && a.Lambda.coeffs() == b.Lambda.coeffs() && a.v == b.v && a.a == b.a &&
           a.omega == b.omega && a.alpha == b.alpha;
}

bool is_same(const LedgerRow& a, const LedgerRow& b) {
    return a.kinetic_energy == b.kinetic_energy && a.strain_energy == b.strain_energy &&
           a.external_work == b.external_work && a.dissipated_energy == b.dissipated_energy &&
           a.numerical_dissipation == b.numerical_dissipation && a.work_uncertainty == b.work_uncertainty &&
           a.energy_error == b.energy_error && a.linear_momentum == b.linear_momentum &&
           a.angular_momentum == b.angular_momentum;
}

template <class T>
bool are_same(const std::vector<T>& a, const std::vector<T>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return is_same(x, y); });
}

}  // namespace

TEST_CASE("The number of threads changes no bit", "[analyses][threads]") {
    const std::string dynamic = "[analysis]\nkind = \"dynamic\"\nend_time = 0.02\ntime_step = 0.01\n";
    const std::string analysis = GENERATE_COPY(
        as<std::string>{},
        dynamic,
        dynamic + "integrator = \"newmark-ibrahimbegovic\"\n",
        dynamic + "integrator = \"generalized-alpha\"\n",
        dynamic + "integrator = \"sdirk-4\"\n",
        dynamic + "linear_solver = \"klu\"\n",
        "[analysis]\nkind = \"dynamic\"\nend_time = 2e-7\ntime_step = 1e-7\nintegrator = \"runge-kutta-4\"\n",
        "[analysis]\nkind = \"static\"\nsteps = 2\n");
    INFO(analysis);
    const Outcome alone = run(analysis, 1);
    REQUIRE(alone.summary.status == RunStatus::complete);
    CHECK(alone.summary.threads == 1);
    for (const int threads : {2, 3}) {
        CAPTURE(threads);
        const Outcome shared = run(analysis, threads);
        CHECK(shared.summary.threads == threads);
        CHECK(shared.summary.totals.newton_iterations == alone.summary.totals.newton_iterations);
        CHECK(are_same(shared.motions, alone.motions));
        CHECK(are_same(shared.ledger, alone.ledger));
        CHECK(shared.reactions == alone.reactions);
    }
}

// Each reads its deck and builds its problem, as whoever drives several at once does.
TEST_CASE("Two simulations at once give the bits of one", "[analyses][threads]") {
    const std::string analysis =
        "[analysis]\nkind = \"dynamic\"\nend_time = 0.03\ntime_step = 0.01\nintegrator = "
        "\"generalized-alpha\"\n";
    const Outcome alone = run(analysis, 1);
    REQUIRE(alone.summary.status == RunStatus::complete);
    std::array<Outcome, 2> both;
    {
        const std::jthread other([&] { both[0] = run(analysis, 1); });
        both[1] = run(analysis, 1);
    }
    for (const Outcome& one : both) {
        CHECK(are_same(one.motions, alone.motions));
        CHECK(are_same(one.ledger, alone.ledger));
        CHECK(one.reactions == alone.reactions);
    }
}

}  // namespace gxrod::test
