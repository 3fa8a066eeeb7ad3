#include "run/signal_value.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {
namespace {

// The integral of a controller whose output is beyond a bound does not grow further to that side.
bool winds_up(const SignalPlan& plan, double output, double error) {
    return (plan.upper && output > *plan.upper && error > 0.0) ||
           (plan.lower && output < *plan.lower && error < 0.0);
}

int find_bound(const SignalPlan& plan, double value) {
    if (plan.upper && value > *plan.upper) return 1;
    return plan.lower && value < *plan.lower ? -1 : 0;
}

}  // namespace

double compute_signal(const SignalPlan& plan,
                      const SignalTimes& times,
                      SignalState& state,
                      std::optional<SignalPiece>& piece) {
    const bool is_held = piece.has_value();
    if (!is_held) piece.emplace();
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
        const double mean = plan.is_continuous ? 0.5 * (before + now) : now;
        const double integral = state.integral + elapsed * mean;
        if (!is_held)
            piece->winds_up = winds_up(plan, without + gains.integral * integral, gains.integral * now);
        if (!piece->winds_up) state.integral = integral;
        value = without + gains.integral * state.integral;
    }
    if (!is_held) piece->bound = find_bound(plan, value);
    if (piece->bound != 0) value = piece->bound > 0 ? *plan.upper : *plan.lower;
    state.largest = std::max(state.largest, std::abs(value));
    return value;
}

std::vector<const SignalPlan*> list_signals(const Problem& problem) {
    std::vector<const SignalPlan*> plans;
    for (const SignalPlan& plan : problem.signals) plans.push_back(&plan);
    std::ranges::stable_sort(plans, {}, [](const SignalPlan* plan) { return plan->input->signal_rank(); });
    return plans;
}

}  // namespace gxrod
