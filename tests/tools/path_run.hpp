#pragma once

#include "analyses/path/path.hpp"
#include "tools/catch.hpp"

namespace gxrod::tools {

// An accepted equilibrium of a path: the load factor and where a node is.
struct PathPlace {
    double load = 0.0;
    Vec3 moved = Vec3::Zero();
    std::int64_t pivots = -1;
};

struct PathRun {
    std::vector<PathPlace> places;
    std::vector<CriticalPoint> points;
    std::vector<PathPlace> at_points;  // of each
    std::vector<BranchStart> branches;
    std::vector<std::string> findings;
    long steps = 0;
    long iterations = 0;
    double worst_energy_error = 0.0;  // relative to the largest strain energy

    // The place with this value of a component, the `which`-th of them.
    PathPlace find(int component, double value, int which = 0) const {
        for (const PathPlace& place : places) {
            if (std::abs(place.moved[component] - value) < 1e-9 * (1.0 + std::abs(value)) && which-- == 0)
                return place;
        }
        FAIL("the path has no equilibrium there");
        return {};
    }
};

inline PathRun run_path(const Model& model,
                        const PathSettings& settings,
                        int node,
                        const BranchStart* branch = nullptr) {
    PathAnalysis analysis(model, settings);
    PathRun run;
    REQUIRE((branch ? analysis.start(*branch) : analysis.start()).converged());
    double largest = 0.0, worst = 0.0;
    while (!analysis.finished()) {
        const EquilibriumReport report = analysis.advance();
        if (!report.converged()) FAIL(describe_failure(analysis.explain(report)));
        const auto index = static_cast<std::size_t>(node);
        run.places.push_back({analysis.row().load_factor,
                              analysis.state().trial[index].r - model.nodes[index].position,
                              analysis.solver_row().negative_pivots});
        ++run.steps;
        run.iterations += analysis.solver_row().newton_iterations;
        largest = std::max(largest, analysis.ledger_row().strain_energy);
        worst = std::max(worst, std::abs(analysis.ledger_row().energy_error));
        while (run.at_points.size() < analysis.critical_points().size())
            run.at_points.push_back(run.places.back());
    }
    run.points = analysis.critical_points();
    run.branches = analysis.branches();
    run.findings = analysis.list_findings();
    run.worst_energy_error = worst / largest;
    return run;
}

}  // namespace gxrod::tools
