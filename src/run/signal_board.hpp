#pragma once

#include <span>
#include <string>
#include <vector>

#include "analyses/stepped_analysis.hpp"
#include "model/problem.hpp"
#include "state/records/signal_state.hpp"
#include "watch/history_watch.hpp"

namespace gxrod {

// The signals of a run: measures them after each accepted step, and sets their inputs before the next one.
class SignalBoard {
  public:
    // The problem must outlive it.
    explicit SignalBoard(const Problem& problem);

    bool empty() const { return signals_.empty(); }
    // Takes the measures from the last accepted step.
    void measure(const Snapshot& snapshot);
    // Sets the inputs for the next step of an analysis in time, whose t is 0 at `axis_start` on the axis that
    // stages share. Throws EvaluationError if a signal's value is not finite.
    void act(const SteppedAnalysis& analysis, double axis_start);

    std::vector<SignalState> states() const;
    void recall(std::span<const SignalState> states);
    // Warnings, a sentence each: signals that change to and fro from step to step.
    std::vector<std::string> list_warnings() const;

  private:
    struct Signal {
        const SignalPlan* plan;
        std::vector<HistoryWatch> watch;  // one, of what is measured
        SignalState state = {};
        // Changes from step to step, which warnings are about.
        double last = 0.0, change = 0.0, largest = 0.0;
        long changes = 0, reversals = 0;
    };

    // The times of the last accepted step, of the stage and on the axis that stages share.
    struct Times {
        double stage, axis;
    };
    static double compute(Signal& signal, const Times& times);
    static void note_change(Signal& signal, double value);

    std::vector<Signal> signals_;  // each after those that it reads
};

}  // namespace gxrod
