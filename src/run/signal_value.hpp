#pragma once

#include <optional>
#include <vector>

#include "model/problem.hpp"
#include "state/records/signal_state.hpp"

namespace gxrod {

// The times of an accepted step, of the stage and on the axis that stages share.
struct SignalTimes {
    double stage = 0.0, axis = 0.0;
};

// The sides of its kinks on which a signal is.
struct SignalPiece {
    bool winds_up = false;  // its integral does not grow
    int bound = 0;          // −1 at `lower`, 1 at `upper`
};

// Computes the value of a signal by what its state has as measured, and advances the state to these times.
// It is held on the given piece; without one it finds its piece.
double compute_signal(const SignalPlan& plan,
                      const SignalTimes& times,
                      SignalState& state,
                      std::optional<SignalPiece>& piece);

// Lists the signals of a problem, each after those that it reads.
std::vector<const SignalPlan*> list_signals(const Problem& problem);

}  // namespace gxrod
