#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "deck/problem.hpp"
#include "run/signal_board.hpp"
#include "run/stage_sequence.hpp"
#include "watch/history_watch.hpp"

namespace gxrod {

// Runs a deck's text in memory, without a results file, for studies.
class DeckRun {
  public:
    // Takes the deck's text, and its name for messages. Throws DeckError.
    DeckRun(const std::string& name, const std::string& text, const std::vector<std::string>& overrides);

    const Problem& problem() const { return problem_; }
    // Returns the analysis of the current stage.
    SteppedAnalysis& analysis() { return stages_->analysis(); }
    std::string stage() const { return stages_->name(); }
    // Returns the load factor of a stage that follows limit points; NaN in other stages.
    double limit_load_factor() const;
    // Returns the time on the axis that stages share.
    double time() const { return stages_->axis(); }
    double end_time() const { return find_axis_end(problem_.stages); }

    // Runs all stages to the end and calls visit at the start and after each accepted step. Throws
    // std::runtime_error if a step fails.
    void run(const std::function<void()>& visit);

    // Returns the present value of a quantity of one of the deck's histories. Throws std::runtime_error if
    // there is none.
    HistoryRow value(const std::string& history, const std::string& quantity);

    // Returns the records of stages that follow paths, in order: each begins with the main path, which has
    // the stage's name.
    const std::vector<PathRecord>& paths() const { return paths_; }
    // Returns the results of stages without steps, in order.
    const std::vector<FoundShapes>& shapes() const { return shapes_; }

    long steps() const { return steps_; }
    long newton_iterations() const { return newton_iterations_; }
    double seconds() const { return seconds_; }  // time of run, without the time in visit

  private:
    void check(const EquilibriumReport& report);
    void measure_signals();
    void find_shapes();
    // Runs to the end of the stage and of the branches of its path.
    void run_steps(const std::function<void()>& visit);

    std::string name_;
    Problem problem_;
    std::unique_ptr<StageSequence> stages_;
    SignalBoard signals_;
    std::vector<FoundShapes> shapes_;
    std::vector<PathRecord> paths_;
    long steps_ = 0;
    long newton_iterations_ = 0;
    double seconds_ = 0.0;
};

}  // namespace gxrod
