#include "report/step_blocks.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "deck/decks.hpp"
#include "results/results_file.hpp"

using namespace gxrod;

namespace {

struct Row {
    double time, time_step;
    int rejected;
};

// What the report counts in a file with these rows after that of the start.
StepCuts survey(const std::vector<Row>& rows, double equal_step) {
    const Problem problem = test::read(test::body_deck);
    const test::ScratchFile scratch("cuts.toml", "");
    const std::filesystem::path path = scratch.path().parent_path() / "cuts.vtkhdf";
    {
        ResultsFile file({path}, problem.record, problem.model, problem.output);
        const std::vector<NodeMotion> nodes(1);
        const std::vector<Vec6> reactions(1, Vec6::Zero());
        file.record_step({0.0, nodes, {}, reactions}, {}, {});
        for (const Row& row : rows) {
            SolverRow solver;
            solver.time_step = row.time_step;
            solver.rejected_steps = row.rejected;
            file.record_step({row.time, nodes, {}, reactions}, {}, solver);
        }
        file.close(RunStatus::complete, "");
    }
    return survey_cuts(Hdf5Reader(path), rows.size() + 1, equal_step);
}

}  // namespace

TEST_CASE("A report counts cut steps as the run did", "[report]") {
    // Of four steps of 0.1, the second was cut into halves and one of these again, the last into halves.
    const StepCuts cuts = survey({{0.1, 0.1, 0},
                                  {0.15, 0.05, 1},
                                  {0.175, 0.025, 1},
                                  {0.2, 0.025, 0},
                                  {0.3, 0.1, 0},
                                  {0.35, 0.05, 4},
                                  {0.4, 0.05, 0}},
                                 0.1);
    CHECK(cuts.steps == 4);
    CHECK(cuts.cut_steps == 2);
    CHECK(cuts.cuts == 6);
    CHECK(cuts.by_error == 0);
}

TEST_CASE("Of steps chosen by their error, a report counts each, and cuts as due to it", "[report]") {
    const StepCuts cuts = survey({{0.1, 0.1, 0}, {0.3, 0.2, 2}, {0.7, 0.4, 1}}, 0.0);
    CHECK(cuts.steps == 3);
    CHECK(cuts.cut_steps == 2);
    CHECK(cuts.cuts == 3);
    CHECK(cuts.by_error == 3);
}
