#include "deck/decks.hpp"
#include "model/settings/analysis_traits.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using test::faults_of;
using test::read;

namespace {

// Lines 1 to 8; text that is added begins in line 9.
const std::string rod = R"([section.s]
stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }
inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = 10
gravity_free = 0
)";

const std::string stages = R"([[stage]]
name = "hang"
kind = "static"
steps = 7
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 3.0
steps = 30
[[stage]]
name = "rest"
kind = "static"
)";

std::string deck_of(const std::string& more) {
    return test::replaced(rod, "gravity_free = 0\n", "") + more + stages;
}

// Of the one load in y, in each stage.
double force_at(const Problem& problem, std::size_t stage, double t) {
    const std::vector<NodalLoad>& loads =
        stage == 0 ? problem.model.loads : problem.stages[stage].actions.loads;
    return loads.empty() ? 0.0 : loads[0].force[1](t);
}

double force_per_length_at(const Problem& problem, std::size_t stage, double t, double s) {
    const auto& loads =
        stage == 0 ? problem.model.distributed_loads : problem.stages[stage].actions.distributed_loads;
    return loads.empty() ? 0.0 : loads[0].force[1](t, s);
}

std::string load_of(const std::string& force, const std::string& more) {
    return deck_of("[[load]]\nat = \"r.end\"\nforce = [0, " + force + ", 0]\n" + more + "\n");
}

std::string line_load_of(const std::string& force, const std::string& more) {
    return deck_of("[[load]]\non = \"r\"\nforce_per_length = [0, " + force + ", 0]\n" + more + "\n");
}

}  // namespace

TEST_CASE("Stages have the keys of an analysis and a name", "[deck][stages]") {
    const Problem problem = read(deck_of(""), {"stage[2].steps=3"});
    REQUIRE(problem.stages.size() == 3);
    CHECK(problem.stages[0].name == "hang");
    CHECK(std::get<StaticSettings>(problem.stages[0].analysis).steps == 7);
    CHECK(std::get<DynamicSettings>(problem.stages[1].analysis).end_time == 3.0);
    CHECK(std::get<StaticSettings>(problem.stages[2].analysis).steps == 3);
    CHECK(std::get<StaticSettings>(problem.analysis()).steps == 7);
    CHECK(problem.record.has_statics);
    CHECK_FALSE(problem.record.is_static);
    CHECK(find_axis_start(problem.stages) == -1.0);
    CHECK(find_axis_end(problem.stages) == 4.0);
}

TEST_CASE("A load without t grows in a first static stage and stays", "[deck][stages]") {
    const Problem problem = read(load_of("6", ""));
    CHECK(force_at(problem, 0, 0.25) == 1.5);
    CHECK(force_at(problem, 1, 0.25) == 6.0);
    CHECK(force_at(problem, 2, 0.25) == 6.0);
    const Problem along = read(line_load_of("\"6*s\"", ""));
    CHECK(force_per_length_at(along, 0, 0.25, 2.0) == 3.0);
    CHECK(force_per_length_at(along, 1, 0.25, 2.0) == 12.0);
}

TEST_CASE("A load with t is as written in each stage's own t", "[deck][stages]") {
    const Problem problem = read(load_of("\"6*t\"", ""));
    for (const std::size_t stage : {0, 1, 2}) CHECK(force_at(problem, stage, 0.5) == 3.0);
}

TEST_CASE("A factor for all stages multiplies the load in each", "[deck][stages]") {
    const Problem problem = read(load_of("\"6*t\"", "factor = \"1 + t\""));
    for (const std::size_t stage : {0, 1, 2}) CHECK(force_at(problem, stage, 0.5) == 4.5);
    CHECK(force_at(read(load_of("6", "factor = 2")), 0, 0.5) == 12.0);
}

TEST_CASE("Of a factor by stage, the last one stays, and before the first there is no load",
          "[deck][stages]") {
    const Problem problem = read(load_of("6", "factor = { swing = \"t^2\" }"));
    CHECK(force_at(problem, 0, 1.0) == 0.0);
    CHECK(force_at(problem, 1, 2.0) == 24.0);
    CHECK(force_at(problem, 2, 0.5) == 54.0);
    const Problem along = read(line_load_of("\"s < 4 ? 1 : t\"", "factor = { swing = \"t^2\" }"));
    CHECK(force_per_length_at(along, 0, 1.0, 1.0) == 0.0);
    CHECK(force_per_length_at(along, 1, 2.0, 1.0) == 4.0);
    CHECK(force_per_length_at(along, 1, 2.0, 5.0) == 8.0);
    CHECK(force_per_length_at(along, 2, 0.5, 1.0) == 9.0);
    CHECK(force_per_length_at(along, 2, 0.5, 5.0) == 27.0);
    // Integrals along the rod see where it switches.
    REQUIRE(along.stages[2].actions.distributed_loads[0].force[1].switches());
    CHECK(along.stages[2].actions.distributed_loads[0].force[1].switches()->size() == 1);
}

TEST_CASE("Loads and supports act in the stages that they name", "[deck][stages]") {
    const Problem problem = read(load_of("6", "stages = [\"swing\", \"rest\"]"));
    CHECK(force_at(problem, 0, 1.0) == 0.0);
    CHECK(force_at(problem, 1, 1.0) == 6.0);
    const Problem held = read(deck_of("[[support]]\nat = \"r.start\"\nfix = \"all\"\nstages = \"swing\"\n"));
    CHECK(held.model.supports.empty());
    CHECK(held.stages[1].actions.supports.size() == 1);
    CHECK(held.stages[2].actions.supports.empty());
}

TEST_CASE("Faults of stages say what is expected", "[deck][stages]") {
    CHECK(faults_of(deck_of("[[load]]\nat = \"r.end\"\nforce = [0, 1, 0]\nstages = [\"swin\"]\n")) ==
          "x.toml:11:11: load[0].stages[0]: no stage \"swin\"; did you mean \"swing\"?");
    CHECK(faults_of(load_of("1", "factor = { hung = 1 }")) ==
          "x.toml:11:19: load[0].factor.hung: no stage \"hung\"; did you mean \"hang\"?");
    CHECK(faults_of(deck_of("[[stage]]\nname = \"a b\"\nkind = \"static\"\n")) ==
          "x.toml:9:8: stage[0].name: expected letters, digits, _ and -, found \"a b\"");
    CHECK(faults_of(deck_of("[[stage]]\nname = \"rest\"\nkind = \"static\"\n")) ==
          "x.toml:21:8: stage[3].name: \"rest\" names an earlier stage, too");
    CHECK(faults_of(deck_of("[analysis]\nkind = \"static\"\n")) ==
          "x.toml:10:3: stage: analysis is given too; only one of them can be");
    CHECK(faults_of(test::static_rod_deck +
                    "[[load]]\nat = \"r.end\"\nforce = [0, 1, 0]\nstages = [\"a\"]\n") ==
          "x.toml:14:11: load[0].stages[0]: no stage \"a\"; the deck has no [[stage]]");
    CHECK(faults_of(deck_of("[[initial]]\non = \"r\"\nvelocity = [1, 0, 0]\n")) ==
          "x.toml:8:1: initial[0]: the first stage, hang, has no velocities; only dynamic ones have");
}

TEST_CASE("Faults of stages that find shapes say what is expected", "[deck][stages]") {
    const auto faults_with = [](const std::string& kind, const std::string& keys) {
        return faults_of(test::replaced(test::static_rod_deck, "\"static\"", "\"" + kind + "\"") + keys);
    };
    CHECK(faults_with("modes", "count = 0") ==
          "x.toml:11:9: analysis.count: expected an integer from 1 to 10000, found 0");
    CHECK(faults_with("modes", "count = 3\nbelow = 2.0") ==
          "x.toml:12:1: analysis.below: count is given too; only one of them can be");
    CHECK(faults_with("buckling", "below = 2.0") ==
          "x.toml:11:1: analysis.below: kind \"buckling\" does not use this key; it is for modes");
    CHECK(faults_with("modes", "integrator = \"sdirk-4\"") ==
          "x.toml:11:1: analysis.integrator: kind \"modes\" does not use this key; it is for dynamic");
    CHECK(faults_of(deck_of("[[load]]\nat = \"r.end\"\nforce = [0, 1, 0]\nstages = \"tones\"\n") +
                    "[[stage]]\nname = \"tones\"\nkind = \"modes\"\n") ==
          "x.toml:11:10: load[0].stages: stage \"tones\" moves nothing: it has the loads and supports of the "
          "stage before it");
}

TEST_CASE("Faults of rotation say what is expected", "[deck][stages]") {
    const auto staged = [](const std::string& more) {
        const std::string deck =
            test::replaced(test::static_rod_deck, "[analysis]", "[[stage]]\nname = \"turn\"");
        return faults_of(test::replaced(deck, "\"static\"", "\"steady\"") + more);
    };
    CHECK(staged("") ==
          "x.toml:11:8: stage[0].kind: a steady stage turns with [rotation], which the deck does not have");
    CHECK(staged("[rotation]\nspeed = 2\naxis = [0, 0, 0]\n") ==
          "x.toml:14:8: rotation.axis: expected a vector that is not zero");
    CHECK(staged("[[stage]]\nname = \"tones\"\nkind = \"modes\"\n[rotation]\nspeed = 2\n") ==
          "x.toml:14:8: stage[1].kind: the stage before turns, and its motions need kind \"eigenvalues\"");
    CHECK(faults_of(test::static_rod_deck + "[rotation]\nspeed = 2\n") ==
          "x.toml:11:1: rotation: stages of kind steady turn with it, and the deck has none");
}
