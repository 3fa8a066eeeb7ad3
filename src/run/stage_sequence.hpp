#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "analyses/static.hpp"
#include "model/stage.hpp"
#include "state/mode_record.hpp"

namespace gxrod {

// What a stage without steps has found.
struct FoundShapes {
    std::string stage;  // its name, or its kind if it has none
    ShapesRecord record;
};

// The stages of a run: the analysis at hand, and what goes over from one to the next.
class StageSequence {
  public:
    struct Plan {
        const Model& model;                 // with what acts in the first stage
        const AnalysisSettings& analysis;   // of the first stage
        std::span<const StagePlan> stages;  // all of them; empty if there is but the first
        std::vector<RodPlace> watched;      // as SteppedAnalysis::watch
        int threads = 1;
    };

    // What the plan refers to must outlive the sequence. Builds the analysis of the first stage that takes
    // steps, or of the one in which a run is resumed.
    explicit StageSequence(Plan plan);
    StageSequence(Plan plan, const RestartRecord& record);

    SteppedAnalysis& analysis() { return *current_.analysis; }
    const SteppedAnalysis& analysis() const { return *current_.analysis; }
    // Of the stage at hand.
    const Model& model() const { return current_.model ? *current_.model : plan_.model; }
    const AnalysisSettings& settings() const;
    std::size_t index() const { return index_; }
    std::string name() const { return plan_.stages.empty() ? "" : plan_.stages[index_].name; }
    // 0 … 1: of all stages, as if each took as long.
    double part_done() const;
    bool is_last() const { return index_ + 1 >= plan_.stages.size(); }
    // The stage whose steps led to the state: the one at hand, or an earlier one if that finds shapes.
    std::size_t moving_index() const { return moving_index_; }

    // Where t of the stage at hand begins on the axis that all share, and where the analysis is on it.
    double axis_start() const { return axis_start_; }
    double axis() const { return axis_start_ + analysis().axis_time(); }

    // Continues with the next stage, from where this one ended. As SteppedAnalysis::start_after; a stage that
    // finds shapes keeps analysis and model of the one before it.
    EquilibriumReport enter_next();
    // What the stage at hand, which takes no steps, finds about the last accepted state. Loads are those that
    // act there; buckling about the reference shape multiplies what acts at t = 1.
    FoundShapes find_shapes() const;

    // Of all stages so far.
    PhaseSeconds seconds() const;
    std::vector<std::string> list_warnings() const;
    bool is_unstable() const { return was_unstable_ || analysis().is_unstable(); }

  private:
    struct Current {
        std::unique_ptr<Model> model;  // none of the first stage, whose model is the plan's
        std::unique_ptr<SteppedAnalysis> analysis;
    };

    Current build() const;
    std::string prefix() const { return plan_.stages.size() > 1 ? "stage " + name() + ": " : ""; }

    Plan plan_;
    std::size_t index_ = 0;
    std::size_t moving_index_ = 0;
    double axis_start_ = 0.0;
    Current current_;
    // Of earlier stages.
    PhaseSeconds seconds_;
    std::vector<std::string> warnings_;
    bool was_unstable_ = false;
};

}  // namespace gxrod
