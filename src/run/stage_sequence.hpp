#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analyses/static.hpp"
#include "check/failure_advice.hpp"
#include "model/problem.hpp"
#include "run/path_follower.hpp"
#include "state/records/shapes_record.hpp"

namespace gxrod {

// The results of a stage without steps.
struct FoundShapes {
    std::string stage;  // its name, or its kind if it has none
    ShapesRecord record;
};

// The stages of a run: holds the current analysis and passes states from one stage to the next.
class StageSequence {
  public:
    struct Plan {
        const Problem& problem;
        std::vector<RodPlace> watched;  // as SteppedAnalysis::watch
        std::vector<ContactWatch> watched_contacts = {};
        int threads = 1;
    };

    // Builds the analysis of the first stage that takes steps, or of the stage in which a run is resumed. The
    // objects that the plan refers to must outlive the sequence.
    explicit StageSequence(Plan plan);
    StageSequence(Plan plan, const RestartRecord& record);

    // Returns the current analysis; on a branch of a path, the analysis of the branch.
    SteppedAnalysis& analysis() { return branch_ ? *branch_ : *current_.analysis; }
    const SteppedAnalysis& analysis() const { return branch_ ? *branch_ : *current_.analysis; }
    // Returns the model of the current stage.
    const Model& model() const { return current_.model ? *current_.model : plan_.problem.model; }
    const AnalysisSettings& settings() const;
    std::size_t index() const { return index_; }
    std::string name() const { return name_of(index_); }
    std::string name_of(std::size_t stage) const { return plan_.problem.stages[stage].name; }
    // Returns the settings of the stage whose steps led to the state.
    const AnalysisSettings& moving_settings() const { return settings_of(moving_index_); }
    // Returns the part of all stages that is done, 0 … 1, as if each took as long.
    double part_done() const;
    bool is_last() const { return index_ + 1 >= plan_.problem.stages.size(); }
    // Returns the stage whose steps led to the state: the current one, or an earlier one if it finds shapes.
    std::size_t moving_index() const { return moving_index_; }

    // Return the start of the current stage and the time of the analysis on the axis that stages share.
    double axis_start() const { return axis_start_; }
    double axis() const {
        return axis_end_.value_or(branch_start_.value_or(axis_start_) + analysis().axis_time());
    }

    // Returns the paths that the current stage has followed so far, the current path last. Empty if it
    // follows none.
    const PathRecord& paths() const;
    bool has_critical_points() const { return follower_ && follower_->has_points(); }
    // Marks this row of the histories, the last one, as the first row of the current path.
    void begin_path(std::int64_t row);
    void note_row(std::int64_t row);
    // Ends the current path, or gives it up, and continues with the next branch on the same axis. Returns
    // false if there is none or it has no first equilibrium: the analysis is then the main path's, at its
    // end, where later stages begin.
    bool enter_next_branch(const std::string& cause);
    void leave_branches();
    // Returns the number of the current branch; 0 for the main path.
    int branch() const { return branch_ ? static_cast<int>(paths().size()) - 1 : 0; }
    // Returns t at the end of each stage, for restart records.
    std::vector<double> ends() const;

    // Continues with the next stage from the end of this one, as SteppedAnalysis::start_after does. A stage
    // that finds shapes keeps the analysis and model of the stage before. Returns the reason if the stage
    // cannot start; then, and if this throws, the current stage stays.
    std::optional<Failure> enter_next();
    // Finds the shapes of the current stage, which takes no steps, about the last accepted state and under
    // the loads there; buckling about the reference shape multiplies the loads at t = 1.
    FoundShapes find_shapes() const;

    // Returns the times of all stages so far.
    PhaseSeconds seconds() const;
    std::vector<std::string> list_warnings() const;
    bool is_unstable() const { return was_unstable_ || analysis().is_unstable(); }

  private:
    struct Current {
        std::unique_ptr<Model> model;  // null in the first stage, which uses the plan's model
        std::unique_ptr<SteppedAnalysis> analysis;
    };

    static Plan restore_ends(Plan plan, const RestartRecord& record);
    const AnalysisSettings& settings_of(std::size_t stage) const {
        return plan_.problem.stages[stage].analysis;
    }
    Current build(std::size_t stage) const;
    ResponseRecord find_response_of(const System& system,
                                    const State& state,
                                    const ResponseSettings& settings) const;
    SweepRecord find_sweep(const EigenvalueSettings& settings) const;
    void end_path(const std::string& cause);
    void prepare_path();
    // Names the stage whose steps led to the state.
    std::string prefix() const {
        return plan_.problem.stages.size() > 1 ? "stage " + name_of(moving_index_) + ": " : "";
    }

    Plan plan_;
    std::size_t index_ = 0;
    std::size_t moving_index_ = 0;
    double axis_start_ = 0.0;
    Current current_;
    std::optional<PathFollower> follower_;  // if the stage follows a path
    std::unique_ptr<PathAnalysis> branch_;  // the current branch
    std::optional<double> branch_start_;    // on the axis
    std::optional<double> axis_end_;        // end of a path whose branches were followed
    // Times of earlier stages.
    PhaseSeconds seconds_;
    std::vector<std::string> warnings_;
    bool was_unstable_ = false;
};

}  // namespace gxrod
