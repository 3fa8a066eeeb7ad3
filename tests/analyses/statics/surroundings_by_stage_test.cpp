// Water and ground that are there in some stages alone.

#include <cmath>

#include "deck/decks.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::read;
using test::replaced;

namespace {

// Hangs from its start.
const std::string hung = R"(gravity = [0, 0, -10]
[section.s]
stiffness = { EA = 1e6, GAy = 4e5, GAz = 4e5, GJ = 1e3, EIy = 1e3, EIz = 1e3 }
inertia = { rhoA = 3, rhoIy = 1e-3, rhoIz = 1e-3 }
fluid = { outer_diameter = 0.2, area = 0.02, added_mass = 0.5, drag = 1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [4, 0, 0] }
elements = 4
[[support]]
at = "r.start"
fix = "all"
)";

std::string stage(const std::string& name, const std::string& kind, const std::string& keys) {
    return "[[stage]]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\nnewton = { tolerance = 1e-12 }\n" +
           keys;
}

struct StageEnd {
    std::vector<Vec3> places;
    Vec3 reaction = Vec3::Zero();
    LedgerRow ledger;
};

// The last state of each stage.
std::vector<StageEnd> run_stages(const std::string& deck) {
    const Problem problem = read(deck);
    std::vector<StageEnd> ends(problem.stages.size());
    RunRequest request{problem};
    request.observe = [&](const Snapshot& snapshot, const LedgerRow& ledger) {
        StageEnd& end = ends.at(static_cast<std::size_t>(snapshot.stage));
        end.places.clear();
        end.reaction.setZero();
        for (const NodeMotion& node : snapshot.nodes) end.places.push_back(node.r);
        for (const Vec6& reaction : snapshot.reactions) end.reaction += reaction.head<3>();
        end.ledger = ledger;
    };
    const RunSummary summary = run_analysis(request);
    INFO(summary.reason);
    REQUIRE(summary.status == RunStatus::complete);
    return ends;
}

double distance(const StageEnd& a, const StageEnd& b) {
    REQUIRE(a.places.size() == b.places.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < a.places.size(); ++i)
        largest = std::max(largest, (a.places[i] - b.places[i]).norm());
    return largest;
}

}  // namespace

TEST_CASE("In a stage with half the water half the buoyancy lifts", "[analyses][surroundings]") {
    const std::vector<StageEnd> ends =
        run_stages(hung + "[fluid]\ndensity = 100\nstages = [\"half\", \"whole\"]\n" +
                   "factor = { half = \"0.5*t\", whole = 1 }\n" + stage("dry", "static", "steps = 4\n") +
                   stage("half", "static", "steps = 2\n") + stage("whole", "static", "steps = 2\n") +
                   stage("again", "static", "steps = 2\n"));
    const double weight = 3.0 * 4.0 * 10.0, buoyancy = 100.0 * 0.02 * 4.0 * 10.0;
    CHECK(ends[0].reaction.z() == Approx(weight).epsilon(1e-10));
    CHECK(ends[1].reaction.z() == Approx(weight - 0.5 * buoyancy).epsilon(1e-10));
    CHECK(ends[2].reaction.z() == Approx(weight - buoyancy).epsilon(1e-10));
    CHECK(ends[3].reaction.z() == Approx(weight).epsilon(1e-10));
    CHECK(distance(ends[0], ends[3]) < 1e-9);
    CHECK(distance(ends[0], ends[1]) > 1e-3);
}

TEST_CASE("A pipe that is lowered to ground of a later stage lies as one that always had it",
          "[analyses][surroundings]") {
    const std::string bed = "[seabed]\nz = -0.6\nstiffness = 5e4\n";
    const std::string first = stage("hang", "static", "steps = 8\n");
    const std::string second = stage("lie", "static", "steps = 4\n");
    const std::vector<StageEnd> staged =
        run_stages(hung + bed + "stages = \"lie\"\nfactor = \"t\"\n" + first + second);
    const std::vector<StageEnd> without = run_stages(hung + "[air]\ndensity = 1\n" + first);
    const std::vector<StageEnd> with = run_stages(hung + bed + first);
    CHECK(distance(staged[0], without[0]) < 1e-9);
    CHECK(distance(staged[1], with[0]) < 1e-9);
    CHECK(distance(staged[0], staged[1]) > 0.05);
    // The ground bears what the clamp does not.
    CHECK(staged[1].reaction.z() < 0.9 * staged[0].reaction.z());
}

TEST_CASE("Energy balances where water comes and goes", "[analyses][surroundings]") {
    const auto errors = [](int steps) {
        const std::string time =
            "end_time = 0.4\nsteps = " + std::to_string(steps) + "\nintegrator = \"sdirk-4\"\n";
        const std::vector<StageEnd> ends =
            run_stages(hung + "[fluid]\ndensity = 100\ncurrent = { velocity = [0, 2, 0] }\n" +
                       "stages = [\"wet\", \"thin\"]\nfactor = { wet = 1, thin = 0.3 }\n" +
                       stage("hang", "static", "steps = 4\n") + stage("wet", "dynamic", time) +
                       stage("thin", "dynamic", time) + stage("dry", "dynamic", time));
        CHECK(ends[3].ledger.kinetic_energy > 10.0);
        // Beyond that of the static stage, whose work is that of its steps.
        double largest = 0.0;
        for (const StageEnd& end : ends)
            largest = std::max(largest, std::abs(end.ledger.energy_error - ends[0].ledger.energy_error));
        return largest;
    };
    const double coarse = errors(100), fine = errors(200);
    INFO(coarse << ", " << fine);
    CHECK(std::log2(coarse / fine) > 3.0);
    CHECK(fine < 2e-5);
}

TEST_CASE("A step of a slow motion ends where a factor of water or ground jumps",
          "[analyses][surroundings]") {
    // Buoyancy without drag is a force per length, which jumps between two steps.
    const std::string creeping = replaced(
        replaced(hung, "drag = 1", "drag = 0"), "fluid = {", "damping = { kelvin_voigt = 0.3 }\nfluid = {");
    const std::string slow = stage("slow", "quasi-static", "end_time = 1\ntime_step = 0.1\n");
    const std::vector<StageEnd> wet =
        run_stages(creeping + "[fluid]\ndensity = 100\nfactor = \"t < 0.47 ? 0 : 1\"\n" + slow);
    const std::vector<StageEnd> loaded = run_stages(
        creeping +
        "[air]\ndensity = 1\n[[load]]\non = \"r\"\nforce_per_length = [0, 0, \"t < 0.47 ? 0 : 20\"]\n" +
        slow);
    CHECK(distance(wet[0], loaded[0]) < 1e-9);
    const std::vector<StageEnd> dry = run_stages(creeping + "[air]\ndensity = 1\n" + slow);
    CHECK(distance(wet[0], dry[0]) > 1e-3);
}
