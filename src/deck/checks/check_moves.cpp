#include "deck/checks/check_moves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/output/sample_times.hpp"
#include "model/time/transitions.hpp"

namespace gxrod {
namespace {

// A move that is below this at t = 0, relative to its largest value or to what it moves, is 0 there.
constexpr double round_off = 1e-12;
constexpr long most_samples = 1000;
constexpr long fewest_samples = 64;

// The deck's shape is that at t = 0, so that a motion begins with 0. `size` is that of what moves: the model,
// or 1 rad.
void check_start(const CheckedTimeFunction& move, double size, const BuildContext& context) {
    double start = 0.0;
    try {
        start = move.function(0.0);
        for (const double time : sample_times(context.analysis(), most_samples)) {
            size = std::max(size, std::abs(move.function(time)));
        }
    } catch (const EvaluationError&) {
        return;  // check_functions reports it
    }
    if (std::abs(start) <= round_off * size) return;
    context.faults.add(
        move.place,
        move.path,
        fmt::format("is {:.6g} at t = 0; expected 0 there, since the deck says where things are "
                    "at t = 0",
                    start));
}

// No force moves a support at once: the rods would be torn to where it is, differently at every step size.
void check_jumps(const CheckedTimeFunction& move, const BuildContext& context) {
    const auto& analysis = std::get<DynamicSettings>(context.analysis());
    std::vector<Transition> jumps;
    try {
        const int samples = static_cast<int>(std::clamp(analysis.steps, fewest_samples, most_samples));
        jumps = find_transitions(move.function, {0.0, analysis.end_time}, samples);
    } catch (const EvaluationError&) {
        return;  // check_functions reports it
    }
    const auto first =
        std::find_if(jumps.begin(), jumps.end(), [](const Transition& one) { return one.is_jump; });
    if (first == jumps.end()) return;
    context.faults.add(
        move.place,
        move.path,
        fmt::format("jumps from {:.6g} to {:.6g} at t = {:.6g}; expected a motion without jumps, such as a "
                    "[function] whose table has interpolation = \"cubic\"",
                    first->value_before,
                    first->value_after,
                    first->time));
}

}  // namespace

void check_move(const CheckedTimeFunction& move, double size, const BuildContext& context) {
    if (!is_timed(context.analysis())) return;
    if (context.stage == 0) check_start(move, size, context);
    check_jumps(move, context);
}

}  // namespace gxrod
