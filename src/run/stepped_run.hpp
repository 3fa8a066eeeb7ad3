#pragma once

#include <memory>
#include <optional>
#include <string>

#include "results/results_file.hpp"
#include "run/output_schedule.hpp"
#include "run/run.hpp"
#include "run/run_books.hpp"
#include "run/signal_board.hpp"
#include "run/stage_sequence.hpp"

namespace gxrod {

// An accepted state that a simulation of the same deck returns to, to the last bit.
struct RunCheckpoint {
    RestartRecord record;
    std::int64_t rows = 0;
};

// A run that its owner drives step by step through all stages of its deck, with a results file if the request
// has one. run_analysis drives one to its end.
class SteppedRun {
  public:
    // Builds the system, and creates the file or takes it over. The request is copied, but the objects that
    // it refers to must outlive this. Throws FileError as run_analysis does.
    explicit SteppedRun(RunRequest request);
    ~SteppedRun();

    // Accepts the state at t = 0. Call it first, also for a run that is resumed. Returns false if there is no
    // such state; the summary has the reason.
    bool start();
    // Takes the next step until it is accepted. On the way stages without steps find their shapes, and
    // branches of paths begin. Returns false if the run has ended or failed; then the state is the last
    // accepted one.
    bool step();
    // Returns whether the run has taken its last step.
    bool has_ended() const { return phase_ == Phase::ended; }
    // Ends the run here as interrupted. Does nothing if it has ended.
    void interrupt();
    // Completes the summary and closes the file; nothing comes after it.
    void close();
    const RunSummary& summary() const { return books_.summary(); }

    // As StepSequence::land_on in the current stage, on the axis that stages share. nullopt on a path.
    std::optional<double> land_on(double time);

    // Sets an input of the deck; at the start, or between steps. An input that changes linearly reaches
    // `value` at `until` on the axis that stages share. Throws std::invalid_argument if the deck has none of
    // this name.
    void set_input(const std::string& name, double value, double until);

    // Returns a checkpoint of the last accepted state. Throws std::logic_error on a path that has met
    // critical points.
    RunCheckpoint save() const;
    // Returns to a checkpoint. Throws std::logic_error if the run writes a file, std::invalid_argument if the
    // state belongs to another model.
    void restore(const RunCheckpoint& checkpoint);

    const RunRequest& request() const { return request_; }
    const Problem& problem() const { return request_.problem; }
    const SteppedAnalysis& analysis() const { return stages_->analysis(); }
    const StageSequence& stages() const { return *stages_; }
    // Returns the time of the last accepted step on the axis that stages share.
    double time() const { return stages_->axis(); }
    // Returns the states of the signals, in the order of list_signals.
    std::vector<SignalState> signal_states() const { return signals_.states(); }
    // Returns the last accepted state; valid until the next step.
    Snapshot take_snapshot(bool with_elements = true);

  private:
    enum class Phase { new_run, started, stepping, ended };

    std::unique_ptr<StageSequence> build();
    StageSequence::Plan make_plan() const;
    std::int64_t stage_count() const { return static_cast<std::int64_t>(problem().stages.size()); }
    long frame_interval() const;
    // Calls an action that may throw. If an error ends the run, puts the reason into the summary and returns
    // false.
    template <class Action>
    bool guard(const Action& action);

    bool take_first();
    bool find_next_step();
    void note_end();
    bool go_on();
    bool enter_next_stage();
    void begin_path();
    bool enter_next_branch();
    bool find_shapes();
    // Returns false if the step failed; on a branch, cause_ says why it cannot be followed further.
    bool take_step();
    // Sets the signals for the next step.
    void set_signals();
    void show_last();
    void write_paths();
    StagePlace place_of_stage() const;
    void resume();
    bool take_over(const RestartRecord& record);
    [[noreturn]] void explain_no_step(const std::filesystem::path& path, double time) const;
    void note_interpolants();
    void schedule_output();
    void record();
    void record_within();
    DueOutput find_due() const;
    bool is_frame_due() const;
    // Adds to a snapshot, at this time of the stage, the values that analyses do not set.
    void complete(Snapshot& snapshot, double time);
    RestartRecord restart_record() const;
    std::string describe_place() const;
    void leave_path();
    void write_end();

    RunRequest request_;
    RunBooks books_;
    SignalBoard signals_;
    double setup_seconds_ = 0.0;
    double output_seconds_ = 0.0;
    std::unique_ptr<StageSequence> stages_;
    std::unique_ptr<ResultsFile> file_;
    OutputSchedule schedule_;  // schedule of the current stage
    Phase phase_ = Phase::new_run;
    bool is_closed_ = false;
    std::string cause_;              // why a branch of a path was given up
    std::string entering_;           // "stage NAME: " while the stage starts
    std::size_t written_paths_ = 0;  // number of the last stage whose paths were written, from 1
    std::int64_t rows_ = 0;          // rows of the histories
    RunTotals accepted_totals_;      // without the cost of a step that failed
    bool has_started_ = false;       // has recorded an accepted state
    bool last_framed_ = false;
    double recorded_time_ = 0.0;  // time of the last row of the results
    std::vector<double> input_values_;
};

}  // namespace gxrod
