#include "run/signal_board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/evaluation_error.hpp"
#include "run/signal_value.hpp"

namespace gxrod {
namespace {

void check_finite(const SignalPlan& plan, double value, double time) {
    if (!std::isfinite(value))
        throw EvaluationError(fmt::format("signal {} is not a finite number at t = {:.6g}", plan.name, time));
}

}  // namespace

SignalBoard::SignalBoard(const Problem& problem) {
    for (const SignalPlan* plan : list_signals(problem)) {
        Signal signal{plan, {}};
        if (plan->measure)
            signal.watch.emplace_back(problem.model, problem.output.histories, plan->measure->history);
        signals_.push_back(std::move(signal));
    }
}

double SignalBoard::measure(Signal& signal, const Snapshot& snapshot) {
    const SignalPlan::Measure& measure = *signal.plan->measure;
    return signal.watch.front().compute(measure.quantity, snapshot)[measure.column];
}

void SignalBoard::measure(const Snapshot& snapshot) {
    for (Signal& signal : signals_) {
        if (!signal.watch.empty()) signal.state.measured = measure(signal, snapshot);
    }
}

void SignalBoard::note_change(Signal& signal, double value) {
    const double change = value - signal.last;
    signal.largest = std::max(signal.largest, std::abs(value));
    if (change * signal.change < 0.0 && std::abs(change) > 1e-3 * signal.largest) ++signal.reversals;
    ++signal.changes;
    signal.change = change;
    signal.last = value;
}

void SignalBoard::act(SteppedAnalysis& analysis, double axis_start) {
    if (signals_.empty()) return;
    const SignalTimes times{analysis.state().time, axis_start + analysis.state().time};
    for (Signal& signal : signals_) {
        // Set already, before a step that failed.
        if (signal.state.is_started != 0.0 && signal.state.time == times.axis) continue;
        std::optional<SignalPiece> piece;
        const double value = compute_signal(*signal.plan, times, signal.state, piece);
        check_finite(*signal.plan, value, times.stage);
        if (signal.plan->is_continuous) {
            start_course(signal, value, times.stage);
            continue;
        }
        signal.plan->input->set(value, times.stage, analysis.steps().next_time());
        note_change(signal, value);
    }
    axis_start_ = axis_start;
    analysis.follow(has_continuous() ? this : nullptr);
    analysis.system().forget_loads();
}

bool SignalBoard::has_continuous() const {
    return std::ranges::any_of(signals_, [](const Signal& signal) { return signal.plan->is_continuous; });
}

// It goes on from where it was, as it went before.
void SignalBoard::start_course(Signal& signal, double value, double time) {
    Input& input = *signal.plan->input;
    const InputState before = input.state();
    const double length = before.to_time - before.from_time;
    signal.from = before.is_set != 0.0 ? input(time) : value;
    signal.slope = before.is_set != 0.0 && length > 0.0 ? (before.to - before.from) / length : 0.0;
    input.lead(time, signal.from, time, signal.from);
}

void SignalBoard::begin(double from, double to) {
    step_from_ = from;
    for (Signal& signal : signals_) {
        if (!signal.plan->is_continuous) continue;
        signal.was_tried = false;
        signal.plan->input->lead(from, signal.from, to, signal.from + signal.slope * (to - from));
    }
}

// By the secant of the last two trials: what a signal is at the end of a step depends on where it goes in it.
double SignalBoard::choose_end(Signal& signal, double found) {
    constexpr double least = 0.1;  // of 1 less the slope
    const double end = signal.plan->input->end();
    double next = found;
    if (signal.was_tried && end != signal.tried) {
        const double slope = (found - signal.found) / (end - signal.tried);
        if (std::abs(1.0 - slope) > least) next = (found - slope * end) / (1.0 - slope);
    }
    signal.was_tried = true;
    signal.tried = end;
    signal.found = found;
    return next;
}

bool SignalBoard::follow(const Snapshot& trial, double time) {
    constexpr double tolerated = 1e-10;
    bool has_changed = false;
    for (Signal& signal : signals_) {
        if (!signal.plan->is_continuous) continue;
        SignalState state = signal.state;
        if (!signal.watch.empty()) state.measured = measure(signal, trial);
        std::optional<SignalPiece> piece;
        const double found = compute_signal(*signal.plan, {time, axis_start_ + time}, state, piece);
        check_finite(*signal.plan, found, time);
        if (std::abs(found - signal.plan->input->end()) <= tolerated * state.largest) continue;
        has_changed = true;
        signal.plan->input->lead(step_from_, signal.from, time, choose_end(signal, found));
    }
    return has_changed;
}

std::vector<SignalState> SignalBoard::states() const {
    std::vector<SignalState> states;
    for (const Signal& signal : signals_) states.push_back(signal.state);
    return states;
}

void SignalBoard::recall(std::span<const SignalState> states) {
    for (std::size_t i = 0; i < signals_.size(); ++i) {
        signals_[i].state = states[i];
        signals_[i].last = signals_[i].change = 0.0;
    }
}

std::vector<std::string> SignalBoard::list_warnings() const {
    constexpr long few = 6;
    constexpr double most = 0.25;  // of all steps
    std::vector<std::string> warnings;
    for (const Signal& signal : signals_) {
        if (signal.reversals < few ||
            static_cast<double>(signal.reversals) < most * static_cast<double>(signal.changes))
            continue;
        warnings.push_back(
            fmt::format("signal {} goes to and fro from step to step, {} times in {} steps: it acts one step "
                        "after what it "
                        "measures, and that is too late for its gains; take shorter steps or smaller gains",
                        signal.plan->name,
                        signal.reversals,
                        signal.changes));
    }
    return warnings;
}

}  // namespace gxrod
