#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analyses/static.hpp"
#include "check/failure_advice.hpp"
#include "model/settings/stage.hpp"
#include "run/path_follower.hpp"
#include "state/records/shapes_record.hpp"

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
        std::vector<ContactWatch> watched_contacts = {};
        int threads = 1;
    };

    // What the plan refers to must outlive the sequence. Builds the analysis of the first stage that takes
    // steps, or of the one in which a run is resumed.
    explicit StageSequence(Plan plan);
    StageSequence(Plan plan, const RestartRecord& record);

    // Of a path that is followed to its branches, that of the branch at hand.
    SteppedAnalysis& analysis() { return branch_ ? *branch_ : *current_.analysis; }
    const SteppedAnalysis& analysis() const { return branch_ ? *branch_ : *current_.analysis; }
    // Of the stage at hand.
    const Model& model() const { return current_.model ? *current_.model : plan_.model; }
    const AnalysisSettings& settings() const;
    std::size_t index() const { return index_; }
    std::string name() const { return name_of(index_); }
    std::string name_of(std::size_t stage) const {
        return plan_.stages.empty() ? "" : plan_.stages[stage].name;
    }
    // Settings of the stage whose steps led to the state.
    const AnalysisSettings& moving_settings() const { return settings_of(moving_index_); }
    // 0 … 1: of all stages, as if each took as long.
    double part_done() const;
    bool is_last() const { return index_ + 1 >= plan_.stages.size(); }
    // The stage whose steps led to the state: the one at hand, or an earlier one if that finds shapes.
    std::size_t moving_index() const { return moving_index_; }

    // Where t of the stage at hand begins on the axis that all share, and where the analysis is on it.
    double axis_start() const { return axis_start_; }
    double axis() const {
        return axis_end_.value_or(branch_start_.value_or(axis_start_) + analysis().axis_time());
    }

    // Of a stage that goes along a path: what it has found so far, the path at hand last. Empty of others.
    const PathRecord& paths() const;
    bool has_critical_points() const { return follower_ && follower_->has_points(); }
    // The rows of the histories from here on are those of the path at hand; the last one is this one.
    void begin_path(std::int64_t row);
    void note_row(std::int64_t row);
    // The path at hand is at its end, or was given up; continues with the next branch, on the same axis.
    // False if there is none, or it has no first equilibrium: then the analysis is that of the main path
    // again, at its end, and later stages begin there.
    bool enter_next_branch(const std::string& cause);
    void leave_branches();
    // Number of the branch at hand, 0 of the main path.
    int branch() const { return branch_ ? static_cast<int>(paths().size()) - 1 : 0; }
    // Where t of each stage ended, to resume from.
    std::vector<double> ends() const;

    // Continues with the next stage, from where this one ended, as SteppedAnalysis::start_after does; a stage
    // that finds shapes keeps analysis and model of the one before it. Returns why the stage cannot start, if
    // so; then, and if it throws, the stage at hand stays what it was.
    std::optional<Failure> enter_next();
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

    static Plan restore_ends(Plan plan, const RestartRecord& record);
    const AnalysisSettings& settings_of(std::size_t stage) const;
    Current build(std::size_t stage) const;
    SweepRecord find_sweep(const EigenvalueSettings& settings) const;
    void end_path(const std::string& cause);
    void prepare_path();
    // Names the stage whose steps led to the state.
    std::string prefix() const {
        return plan_.stages.size() > 1 ? "stage " + name_of(moving_index_) + ": " : "";
    }

    Plan plan_;
    std::size_t index_ = 0;
    std::size_t moving_index_ = 0;
    double axis_start_ = 0.0;
    Current current_;
    std::optional<PathFollower> follower_;  // of a path
    std::unique_ptr<PathAnalysis> branch_;  // at hand
    std::optional<double> branch_start_;    // on the axis
    std::optional<double> axis_end_;        // of a path whose branches were followed
    // Of earlier stages.
    PhaseSeconds seconds_;
    std::vector<std::string> warnings_;
    bool was_unstable_ = false;
};

}  // namespace gxrod
