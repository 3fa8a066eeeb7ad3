#include "solvers/difference_tangent.hpp"

#include <set>

#include "assembly/sample_model.hpp"
#include "integrators/scheme_samples.hpp"
#include "solvers/trial_rates.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("columns of one group share no row", "[solvers]") {
    const Model model = make_sample_model();
    const System system(model);
    const SparsePattern& pattern = system.pattern();
    const auto groups = group_columns(pattern);
    std::set<std::int64_t> all;
    for (const auto& group : groups) {
        std::set<std::int64_t> rows;
        for (const std::int64_t column : group) {
            CHECK(all.insert(column).second);
            pattern.visit_column(column,
                                 [&](std::int64_t row, std::int64_t) { CHECK(rows.insert(row).second); });
        }
    }
    CHECK(static_cast<std::int64_t>(all.size()) == pattern.size());
    // Of a chain, every third node can go into one group.
    CHECK(groups.size() <= 18);
}

TEST_CASE("differences give the tangent of every implicit scheme and restore the state", "[solvers]") {
    const Model model = make_sample_model();
    const System system(model);
    for (const SchemeSample& scheme : all_schemes()) {
        const auto integrator = make_integrator(scheme.settings);
        if (integrator->is_explicit() || scheme.is_coupled()) continue;
        INFO(scheme.name);
        State state = make_sample_state(system, 3);
        integrator->start(state);
        const Stage stage = make_stage(0);
        if (integrator->stage_count() > 1) {
            state.stages.assign(integrator->stage_count(), std::vector<StageRates>(state.trial.size()));
        }
        update_trial_rates(system, *integrator, stage, state);
        const auto before = state.trial;
        std::vector<double> differences, values;
        DifferenceTangent(system).compute(*integrator, stage, state, differences);
        for (std::size_t i = 0; i < before.size(); ++i) {
            CHECK(state.trial[i].r == before[i].r);
            CHECK(state.trial[i].theta == before[i].theta);
            CHECK(stack_rates(state.trial[i]) == stack_rates(before[i]));
        }
        std::vector<NodeLinearization> linearizations(state.trial.size());
        integrator->linearize(state, stage, linearizations);
        system.compute_tangent(state, integrator->stage_time(stage), linearizations, values);
        CHECK(relative_difference(make_dense(system.pattern(), differences),
                                  make_dense(system.pattern(), values)) < 1e-8);
    }
}
