#pragma once

#include "analyses/static.hpp"

#include "tools/catch.hpp"

namespace gxrod::tools {

inline StaticSettings make_static_settings(long steps, double tolerance = 1e-12) {
    StaticSettings settings;
    settings.steps = steps;
    settings.newton.tolerance = tolerance;
    return settings;
}

// Where a run ended and what it took.
struct StaticRun {
    EquilibriumReport report;  // of the last step
    std::string failure;       // in words, "" if there is none
    State state;
    LedgerRow ledger;
    std::vector<SectionValues> elements;
    std::vector<Vec6> reactions;
    long steps = 0;
    long iterations = 0;  // of accepted steps
    long rejected_steps = 0;

    const NodeMotion& node(int index) const { return state.trial[index]; }
    const NodeMotion& tip() const { return state.trial.back(); }
};

// To the end or to where even the shortest step fails.
inline StaticRun try_static(const Model& model, const StaticSettings& settings) {
    StaticAnalysis analysis(model, settings);
    StaticRun run;
    run.report = analysis.start();
    REQUIRE(run.report.converged());
    while (!analysis.finished() && run.report.converged()) {
        run.report = analysis.advance();
        run.rejected_steps += analysis.solver_row().rejected_steps;
        if (!run.report.converged()) {
            run.failure = describe_failure(analysis.explain(run.report));
            break;
        }
        ++run.steps;
        run.iterations += analysis.solver_row().newton_iterations;
    }
    const Snapshot snapshot = analysis.snapshot();
    run.state = analysis.state();
    run.ledger = analysis.ledger_row();
    run.elements.assign(snapshot.elements.begin(), snapshot.elements.end());
    run.reactions.assign(snapshot.reactions.begin(), snapshot.reactions.end());
    return run;
}

// To the end; the test fails if that is not reached.
inline StaticRun run_static(const Model& model, const StaticSettings& settings) {
    StaticRun run = try_static(model, settings);
    if (!run.report.converged()) FAIL(run.failure);
    return run;
}

}  // namespace gxrod::tools
