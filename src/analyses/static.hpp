#pragma once

#include "analyses/stepped_analysis.hpp"
#include "check/motions/stability.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// Finds equilibria while the load factor runs from 0, the reference shape, to 1.
class StaticAnalysis : public SteppedAnalysis {
  public:
    // The model must outlive the analysis.
    StaticAnalysis(const Model& model, const StaticSettings& settings, int threads = 1);

    EquilibriumReport start() override;
    std::vector<std::string> list_warnings() const override;
    std::vector<std::string> list_findings() const override { return findings_; }
    bool is_unstable() const override;

  protected:
    EquilibriumReport solve_trial() override;
    bool tries_otherwise(const EquilibriumReport& report, bool is_shortest) override;
    bool has_relaxed() const override { return relaxes_; }
    // Rejects an equilibrium with more negative pivots than the last one, since it lies beyond a bifurcation
    // or on another branch; shorter steps seek a stable equilibrium first.
    void judge_equilibrium(EquilibriumReport& report) override;
    void note_equilibrium() override;
    bool settles_after_stage() const override { return true; }
    std::int64_t accepted_pivots() const override { return accepted_; }
    std::int64_t counted_pivots() const override { return has_potential_ && is_counted_ ? accepted_ : -1; }
    void resume_pivots(std::int64_t pivots) override { accepted_ = pivots; }

  private:
    Stage current_stage() const;
    // Whether the next step may relax: only the first step of a stage, before any stable branch is reached.
    bool may_relax() const;
    // Whether the model moves away from the trial equilibrium in pseudo-time.
    bool diverges();
    // Whether the loads of the next step are large compared with the model's stiffness before it: then no
    // stable branch leads there through shorter steps.
    bool starts_loose();

    bool relaxes_ = false;         // whether the current step relaxes
    bool wants_to_relax_ = false;  // because the equilibrium of Newton's method is not stable
    bool gave_up_ = false;         // after a relaxation that found no equilibrium
    int pseudo_steps_ = 0;
    std::string leaving_shape_;  // how the model moves away from the end, where pivots do not show it
    std::vector<std::string> findings_;
    double nominal_step_;
    PivotCounter counter_;
    bool has_potential_;
    std::int64_t trial_ =
        0;  // negative pivots at the trial equilibrium; without potential, only the sign of det K
    std::int64_t accepted_;   // −1: not counted (any more): with a contrast of stiffness, whose round-off
                              // makes pivots negative, or with an iterative solver
    bool is_counted_ = true;  // whether the last equilibrium's pivots are known
    int sought_ = 0;          // losses of stability that shorter steps could not avoid
    bool was_unstable_ = false;
    std::vector<StabilityChange> changes_;
};

// Makes the analysis that the settings ask for. The threads share its work; their number does not change the
// results.
std::unique_ptr<SteppedAnalysis> make_analysis(const Model& model,
                                               const AnalysisSettings& settings,
                                               int threads = 1);

}  // namespace gxrod
