#include "run/signal_board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/evaluation_error.hpp"

namespace gxrod {
namespace {

// The integral of a controller whose output is beyond a bound does not grow further to that side.
bool winds_up(const SignalPlan& plan, double output, double error) {
    return (plan.upper && output > *plan.upper && error > 0.0) ||
           (plan.lower && output < *plan.lower && error < 0.0);
}

}  // namespace

SignalBoard::SignalBoard(const Problem& problem) {
    for (const SignalPlan& plan : problem.signals) {
        Signal signal{&plan, {}};
        if (plan.measure)
            signal.watch.emplace_back(problem.model, problem.output.histories, plan.measure->history);
        signals_.push_back(std::move(signal));
    }
    std::ranges::stable_sort(
        signals_, {}, [](const Signal& signal) { return signal.plan->input->signal_rank(); });
}

void SignalBoard::measure(const Snapshot& snapshot) {
    for (Signal& signal : signals_) {
        if (signal.watch.empty()) continue;
        const SignalPlan::Measure& measure = *signal.plan->measure;
        const HistoryRow row = signal.watch.front().compute(measure.quantity, snapshot);
        signal.state.measured = row[measure.column];
    }
}

double SignalBoard::compute(Signal& signal, const Times& times) {
    const SignalPlan& plan = *signal.plan;
    SignalState& state = signal.state;
    const double raw = plan.measure ? state.measured : plan.value(times.stage);
    const bool is_first = state.is_started == 0.0;
    const double elapsed = is_first ? 0.0 : times.axis - state.time;
    const double before = is_first ? raw : state.filtered;
    const double part = plan.filter > 0.0 ? -std::expm1(-elapsed / plan.filter) : 1.0;
    const double now = is_first ? raw : before + part * (raw - before);
    const double rate = elapsed > 0.0 ? (now - before) / elapsed : 0.0;
    state.is_started = 1.0;
    state.time = times.axis;
    state.filtered = now;
    double value = plan.is_rate ? rate : now;
    if (plan.pid) {
        const PidGains& gains = *plan.pid;
        const double without = gains.proportional * now + gains.derivative * rate;
        const double integral = state.integral + elapsed * now;
        if (!winds_up(plan, without + gains.integral * integral, gains.integral * now))
            state.integral = integral;
        value = without + gains.integral * state.integral;
    }
    if (plan.lower) value = std::max(value, *plan.lower);
    if (plan.upper) value = std::min(value, *plan.upper);
    return value;
}

void SignalBoard::note_change(Signal& signal, double value) {
    const double change = value - signal.last;
    signal.largest = std::max(signal.largest, std::abs(value));
    if (change * signal.change < 0.0 && std::abs(change) > 1e-3 * signal.largest) ++signal.reversals;
    ++signal.changes;
    signal.change = change;
    signal.last = value;
}

void SignalBoard::act(const SteppedAnalysis& analysis, double axis_start) {
    if (signals_.empty()) return;
    const Times times{analysis.state().time, axis_start + analysis.state().time};
    for (Signal& signal : signals_) {
        // Set already, before a step that failed.
        if (signal.state.is_started != 0.0 && signal.state.time == times.axis) continue;
        const double value = compute(signal, times);
        if (!std::isfinite(value))
            throw EvaluationError(fmt::format(
                "signal {} is not a finite number at t = {:.6g}", signal.plan->name, times.stage));
        signal.plan->input->set(value, times.stage, analysis.steps().next_time());
        note_change(signal, value);
    }
    analysis.system().forget_loads();
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
