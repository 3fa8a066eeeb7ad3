#include <algorithm>
#include <map>

#include "deck/decks.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::read;
using test::replaced;

namespace {

// A cantilever of general stiffness, pulled aside by its tip and let go within a unit of time.
const std::string cantilever = R"(
[section.s]
stiffness = { EA = 1e3, GAy = 5e2, GAz = 5e2, GJ = 0.8, EIy = 1, EIz = 2 }
inertia = { rhoA = 1, rhoJ = 3e-3, rhoIy = 1e-3, rhoIz = 2e-3 }
[rod.wing]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 10
order = 4
[[support]]
at = "wing.start"
fix = "all"
[[load]]
at = "wing.end"
force = [0, 1.5, -2]
moment = [0.4, 0, 0]
factor = { hang = "t", release = "t < 1 ? cos(pi*t/2)^2 : 0" }
[[history]]
name = "tip"
at = "wing.end"
quantities = ["position", "velocity"]
[[stage]]
name = "hang"
kind = "static"
steps = 4
newton = { tolerance = 1e-11 }
[[stage]]
name = "release"
kind = "dynamic"
end_time = 2.0
steps = 800
integrator = "sdirk-4"
newton = { tolerance = 1e-11 }
)";

std::string make_kept() {
    return replaced(
        cantilever, R"({ hang = "t", release = "t < 1 ? cos(pi*t/2)^2 : 0" })", R"({ hang = "t" })");
}

struct Row {
    double time;
    int stage;
    Vec3 tip;
    LedgerRow ledger;
};

struct Traced {
    RunSummary summary;
    std::vector<Row> rows;

    const Row& at(double time) const {
        const auto found = std::find_if(
            rows.begin(), rows.end(), [&](const Row& row) { return std::abs(row.time - time) < 1e-9; });
        REQUIRE(found != rows.end());
        return *found;
    }
};

Traced trace(const Problem& problem) {
    Traced traced;
    RunRequest request{problem};
    request.observe = [&](const Snapshot& snapshot, const LedgerRow& ledger) {
        traced.rows.push_back({snapshot.time, snapshot.stage, snapshot.nodes.back().r, ledger});
    };
    traced.summary = run_analysis(request);
    return traced;
}

// Notes on what a stage begins with: all but that pivots are unknown under a load that follows.
std::vector<std::string> starts_of(const Traced& traced) {
    std::vector<std::string> notes = traced.summary.notes;
    std::erase_if(notes, [](const std::string& note) { return note.find("pivots") != std::string::npos; });
    return notes;
}

}  // namespace

TEST_CASE("A held cantilever that is let go moves as an independent program says", "[analyses][stages]") {
    const Traced traced = trace(read(cantilever));
    REQUIRE(traced.summary.status == RunStatus::complete);
    const Row& start = traced.at(0.0);
    CHECK(start.stage == 0);
    CHECK((start.tip - Vec3(.81583852, .25278401, -.46062961)).norm() < 2e-8);
    CHECK(start.ledger.strain_energy == Approx(.636103042097).epsilon(1e-10));
    CHECK((traced.at(0.5).tip - Vec3(.865586705, .195893187, -.414435615)).norm() < 1e-7);
    CHECK((traced.at(1.0).tip - Vec3(.994776342, -.093347012, .034820017)).norm() < 1e-7);
    CHECK((traced.at(2.0).tip - Vec3(.982988248, .054991432, -.163920685)).norm() < 3e-7);
    const LedgerRow& end = traced.at(2.0).ledger;
    CHECK(end.kinetic_energy + end.strain_energy == Approx(.251938067766).epsilon(1e-7));
    // The books go on from stage to stage.
    CHECK(std::abs(end.energy_error - start.ledger.energy_error) < 1e-7);
    CHECK(starts_of(traced).empty());
}

TEST_CASE("Nothing moves that starts from rest in equilibrium", "[analyses][stages]") {
    const std::string integrator =
        GENERATE("newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4");
    INFO(integrator);
    const Problem problem =
        read(replaced(make_kept(), "\"sdirk-4\"", "\"" + integrator + "\""), {"stage[1].steps=20"});
    const Traced traced = trace(problem);
    REQUIRE(traced.summary.status == RunStatus::complete);
    CHECK(starts_of(traced).empty());
    for (const Row& row : traced.rows) {
        if (row.stage == 0) continue;
        CHECK((row.tip - traced.at(0.0).tip).norm() < 1e-9);
        CHECK(row.ledger.kinetic_energy < 1e-15);
    }
    CHECK(traced.rows.back().stage == 1);
}

TEST_CASE("A stage that does not begin in equilibrium says where it is out of balance",
          "[analyses][stages]") {
    const std::string gone = replaced(cantilever, "release = \"t < 1 ? cos(pi*t/2)^2 : 0\"", "release = 0");
    const Traced traced = trace(read(gone, {"stage[1].steps=4", "stage[1].end_time=0.01"}));
    REQUIRE(starts_of(traced).size() == 1);
    CHECK(starts_of(traced)[0].find("stage release: it does not begin in equilibrium: out of balance at "
                                    "wing.end (") == 0);
}

TEST_CASE("A support lets go in a later stage, and another one takes hold where the point is",
          "[analyses][stages]") {
    // Hung by both ends, then by the start alone, then held again.
    const std::string deck = replaced(make_kept(), "[[history]]", R"([[support]]
at = "wing@0.5"
fix = "position"
stages = ["hang", "caught"]
[[history]])") + R"([[stage]]
name = "caught"
kind = "static"
steps = 2
)";
    const Problem problem = read(deck, {"stage[1].steps=50", "stage[1].end_time=0.1"});
    CHECK(problem.model.supports.size() == 2);
    CHECK(problem.stages[1].actions.supports.size() == 1);
    const Traced traced = trace(problem);
    REQUIRE(traced.summary.status == RunStatus::complete);
    CHECK(starts_of(traced).size() == 1);  // what the support held
    const Row& released = traced.at(0.1);
    CHECK(released.ledger.kinetic_energy > 1e-3);
    CHECK(traced.rows.back().time == Approx(1.1));
    CHECK(traced.rows.back().ledger.kinetic_energy == 0.0);
    // Motion that stops is dissipated.
    CHECK(traced.rows.back().ledger.dissipated_energy > released.ledger.kinetic_energy);
}

TEST_CASE("A run of stages that was stopped in any of them goes on to the last bit", "[analyses][stages]") {
    const sample::ScratchFolder folder;
    const Problem problem = read(cantilever, {"stage[1].steps=20", "stage[1].end_time=0.1"});
    REQUIRE(run_problem(problem, folder / "whole.vtkhdf").status == RunStatus::complete);
    const int stop = GENERATE(0, 2, 3, 4, 12);
    INFO(stop);
    REQUIRE(run_problem(problem, folder / "part.vtkhdf", stop).status == RunStatus::interrupted);
    REQUIRE(resume_problem(problem, folder / "part.vtkhdf").status == RunStatus::complete);
    const Hdf5Reader whole(folder / "whole.vtkhdf");
    const Hdf5Reader part(folder / "part.vtkhdf");
    for (const std::string& name : whole.datasets()) {
        if (name.starts_with("/restart") || name.starts_with("/deck") || name.starts_with("/rods/")) continue;
        INFO(name);
        CHECK(whole.numbers(name) == part.numbers(name));
    }
    CHECK(whole.numbers("/histories/time").front() == -1.0);
    CHECK(whole.numbers("/histories/stage").back() == 1.0);
    CHECK(part.text_attribute("/stages/release", "kind") == "dynamic");
    CHECK(part.integer_attribute("/stages/release", "first_row") == 5);
    std::filesystem::remove(folder / "part.vtkhdf");
}

TEST_CASE("A support whose move would begin with a jump stops the run with a reason", "[analyses][stages]") {
    const std::string deck = replaced(make_kept(), "fix = \"all\"", R"(fix = "all"
stages = ["hang"]
[[support]]
at = "wing.start"
fix = ["y", "z", "rotation"]
move = { x = "0.1 + t" }
stages = ["release"])");
    const Traced traced = trace(read(deck));
    CHECK(traced.summary.status == RunStatus::failed);
    CHECK(traced.summary.reason.find("the support at wing.start begins with a jump, by 0.1 and 0 rad") !=
          std::string::npos);
}
