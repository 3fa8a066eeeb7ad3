#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "deck/problem.hpp"
#include "results/histories/history_point.hpp"
#include "run/stage_sequence.hpp"

namespace gxrod {

// A deck's text run in memory, without a results file, for studies.
class DeckRun {
  public:
    // Throws DeckError. `name` is what messages call the deck.
    DeckRun(const std::string& name, const std::string& text, const std::vector<std::string>& overrides);

    const Problem& problem() const { return problem_; }
    // Of the stage at hand.
    SteppedAnalysis& analysis() { return stages_->analysis(); }
    std::string stage() const { return stages_->name(); }
    // Of a stage that follows limit points; NaN of others.
    double limit_load_factor() const;
    // On the axis that stages share.
    double time() const { return stages_->axis(); }
    double end_time() const { return find_axis_end(problem_.stages); }

    // Runs all stages to the end and calls visit at the start and after each accepted step. Throws
    // std::runtime_error if a step fails.
    void run(const std::function<void()>& visit);

    // A quantity of one of the deck's histories, now. Throws std::runtime_error if there is no such.
    HistoryPoint::Row value(const std::string& history, const std::string& quantity);

    // What stages along paths have found, in their order: each begins with the main path, of the stage's
    // name.
    const std::vector<PathRecord>& paths() const { return paths_; }
    // What stages without steps have found, in their order.
    const std::vector<FoundShapes>& shapes() const { return shapes_; }

    long steps() const { return steps_; }
    long newton_iterations() const { return newton_iterations_; }
    double seconds() const { return seconds_; }  // of run, less what visit took

  private:
    void check(const EquilibriumReport& report);
    void find_shapes();
    // To the end of the stage, and of the branches of a path.
    void run_steps(const std::function<void()>& visit);

    std::string name_;
    Problem problem_;
    std::unique_ptr<StageSequence> stages_;
    std::vector<FoundShapes> shapes_;
    std::vector<PathRecord> paths_;
    long steps_ = 0;
    long newton_iterations_ = 0;
    double seconds_ = 0.0;
};

}  // namespace gxrod
