#pragma once

#include "analyses/stepped_analysis.hpp"
#include "check/stability.hpp"
#include "model/settings.hpp"

namespace gxrod {

// Equilibria while the load factor runs from 0, the reference shape, to 1.
class StaticAnalysis : public SteppedAnalysis {
  public:
    // The model must outlive the analysis.
    StaticAnalysis(const Model& model, const StaticSettings& settings, int threads = 1);

    EquilibriumReport start() override;
    std::vector<std::string> list_warnings() const override;
    bool is_unstable() const override;

  protected:
    // An equilibrium with more negative pivots than the last one lies beyond a bifurcation or on another
    // branch: shorter steps seek a stable one first.
    void judge_equilibrium(EquilibriumReport& report) override;
    void note_equilibrium() override;
    bool settles_after_stage() const override { return true; }
    std::int64_t accepted_pivots() const override { return accepted_; }
    std::int64_t counted_pivots() const override { return has_potential_ && is_counted_ ? accepted_ : -1; }
    void resume_pivots(std::int64_t pivots) override { accepted_ = pivots; }

  private:
    Stage current_stage() const;

    double nominal_step_;
    PivotCounter counter_;
    bool has_potential_;
    std::int64_t trial_ =
        0;  // negative pivots at the trial equilibrium; of det K's sign alone without potential
    std::int64_t accepted_;   // −1: not counted (any more); with a contrast of stiffness, whose round-off
                              // makes pivots negative, or where iterations solve
    bool is_counted_ = true;  // whether the last equilibrium's pivots are known
    int sought_ = 0;          // losses of stability that shorter steps could not avoid
    bool was_unstable_ = false;
    std::vector<StabilityChange> changes_;
};

// The analysis that the settings ask for; so many threads share its work, and their number changes no result.
std::unique_ptr<SteppedAnalysis> make_analysis(const Model& model,
                                               const AnalysisSettings& settings,
                                               int threads = 1);

}  // namespace gxrod
