#pragma once

#include "analyses/steady.hpp"

#include "tools/static_run.hpp"

namespace gxrod::tools {

// Its speed grows with the load factor.
inline TurningFrame ramped_frame(const Vec3& axis, double speed, const Vec3& through = Vec3::Zero()) {
    return {.axis = axis, .through = through, .speed = TimeFunction([speed](double t) { return speed * t; })};
}

// A run to the end; the test fails if that is not reached.
class SteadyRun {
  public:
    SteadyRun(const Model& model, const TurningFrame& frame, const StaticSettings& settings)
        : analysis_(model, settings, frame) {
        EquilibriumReport report = analysis_.start();
        while (!analysis_.finished()) {
            report = analysis_.advance();
            if (!report.converged()) FAIL(describe_failure(analysis_.explain(report)));
            iterations_ += analysis_.solver_row().newton_iterations;
            rejected_ += analysis_.solver_row().rejected_steps;
        }
        const Snapshot snapshot = analysis_.snapshot();
        reactions_.assign(snapshot.reactions.begin(), snapshot.reactions.end());
    }

    const SteadyAnalysis& analysis() const { return analysis_; }
    const NodeMotion& tip() const { return analysis_.state().trial.back(); }
    const std::vector<Vec6>& reactions() const { return reactions_; }
    long iterations() const { return iterations_; }
    long rejected() const { return rejected_; }

  private:
    SteadyAnalysis analysis_;
    std::vector<Vec6> reactions_;
    long iterations_ = 0, rejected_ = 0;
};

}  // namespace gxrod::tools
