#pragma once

#include <span>
#include <string>
#include <vector>

#include "analyses/step_follower.hpp"
#include "analyses/stepped_analysis.hpp"
#include "model/problem.hpp"
#include "state/records/signal_state.hpp"
#include "watch/history_watch.hpp"

namespace gxrod {

// The signals of a run: measures them after each accepted step, and sets their inputs before the next one.
// Continuous signals go on a straight line through the step to what they are at its end.
class SignalBoard : public StepFollower {
  public:
    // The problem must outlive it.
    explicit SignalBoard(const Problem& problem);

    bool empty() const { return signals_.empty(); }
    // Takes the measures from the last accepted step.
    void measure(const Snapshot& snapshot);
    // Sets the inputs for the next step of an analysis in time, whose t is 0 at `axis_start` on the axis that
    // stages share. Throws EvaluationError if a signal's value is not finite.
    void act(SteppedAnalysis& analysis, double axis_start);

    // Set the course of continuous signals within a step.
    void begin(double from, double to) override;
    bool follow(const Snapshot& trial, double time) override;

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
        // A continuous one: its value at the start of the step, its rate before, the ends of its course that
        // were tried last, and what it was at the ends of these trials.
        double from = 0.0, slope = 0.0, tried = 0.0, found = 0.0;
        bool was_tried = false;
    };

    bool has_continuous() const;
    static double measure(Signal& signal, const Snapshot& snapshot);
    static void start_course(Signal& signal, double value, double time);
    static double choose_end(Signal& signal, double found);
    static void note_change(Signal& signal, double value);

    std::vector<Signal> signals_;  // each after those that it reads
    double axis_start_ = 0.0;
    double step_from_ = 0.0;
};

}  // namespace gxrod
