#pragma once

#include <cmath>
#include <vector>

#include "analyses/dynamic.hpp"
#include "tools/catch.hpp"

namespace gxrod::tools {

inline DynamicSettings make_settings(Scheme scheme, double end_time, long steps) {
    DynamicSettings settings;
    settings.scheme = scheme;
    settings.end_time = end_time;
    settings.steps = steps;
    settings.newton.tolerance = 1e-10;
    return settings;
}

// Runs to the end and calls visit(analysis) at t = 0 and after every step. The test fails if a step does not
// converge or has to be cut.
template <class Visit>
void run(const Model& model, const DynamicSettings& settings, Visit&& visit) {
    DynamicAnalysis analysis(model, settings);
    REQUIRE(analysis.start().converged());
    visit(analysis);
    while (!analysis.finished()) {
        const EquilibriumReport report = analysis.advance();
        if (!report.converged() || analysis.solver_row().rejected_steps > 0)
            FAIL(describe_failure(analysis.explain(report)));
        visit(analysis);
    }
}

// The motion of the model's only node, or its first, at the end.
inline NodeMotion run_to_end(const Model& model, const DynamicSettings& settings) {
    NodeMotion last;
    run(model, settings, [&](const DynamicAnalysis& analysis) { last = analysis.state().trial[0]; });
    return last;
}

// log₂ of how much each error is smaller than the one before, from runs with steps of half the length.
inline std::vector<double> compute_orders(const std::vector<double>& errors) {
    std::vector<double> orders;
    for (std::size_t i = 1; i < errors.size(); ++i) orders.push_back(std::log2(errors[i - 1] / errors[i]));
    return orders;
}

}  // namespace gxrod::tools
