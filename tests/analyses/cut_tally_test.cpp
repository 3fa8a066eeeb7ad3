#include "analyses/cut_tally.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

EquilibriumReport failed(Outcome outcome, int node, int component) {
    EquilibriumReport report;
    report.outcome = outcome;
    report.worst_node = node;
    report.worst_component = component;
    return report;
}

}  // namespace

TEST_CASE("A step that is cut several times counts once, its cuts each", "[analyses]") {
    CutTally tally;
    for (const long step : {3, 3, 3, 7, 8, 8}) tally.add(failed(Outcome::out_of_iterations, 1, 0), step);
    tally.add(failed(Outcome::error_too_large, 1, 0), 9);
    const StepCuts cuts = tally.count(100);
    CHECK(cuts.steps == 100);
    CHECK(cuts.cut_steps == 4);
    CHECK(cuts.cuts == 7);
    CHECK(cuts.by_error == 1);
}

TEST_CASE("Reasons of cuts come with where they were most often, the most frequent first", "[analyses]") {
    const Model model = test::read(test::rod_deck).model;
    const int end = static_cast<int>(model.nodes.size()) - 1;
    CutTally tally;
    CHECK(tally.describe_reasons(model).empty());
    tally.add(failed(Outcome::rotation_too_large, end, -1), 1);
    for (int i = 0; i < 3; ++i) tally.add(failed(Outcome::out_of_iterations, end, 4), i);
    tally.add(failed(Outcome::out_of_iterations, 0, 4), 5);
    CHECK(tally.describe_reasons(model) ==
          "Newton's method did not converge (4 times, mostly at r.end (ry)); a node turned by half a turn or "
          "more within a step (1 time, mostly at r.end)");
}
