#pragma once

#include <functional>

#include "assembly/lanes/frame_columns.hpp"
#include "model/settings/eigenvalue_settings.hpp"
#include "state/records/sweep_record.hpp"

namespace gxrod {

// A state about which eigenvalues are sought; its pointers must be valid until the next state is asked for.
struct SweepState {
    std::string failure;  // why there is no equilibrium, "" if there is
    const System* system = nullptr;
    const State* state = nullptr;
    double time = 0.0;                    // time of loads
    const FrameColumns* frame = nullptr;  // if the state turns with one
    double speed = 0.0;                   // spin of the frame
};

// Finds the equilibrium at a value of the parameter, starting from the equilibrium asked for before. All
// models have the same unknowns.
using FindSweepState = std::function<SweepState(double value)>;

struct SweepSettings {
    EigenvalueSettings eigenvalues{.counts = false};  // `count` modes are followed from the first value on
    bool finds_onset = true;
    bool keeps_shapes = false;
    // If another mode has a larger share of a mode than this, the sweep adds values in between.
    double most_corruption = 0.5;
    int halvings = 4;
};

// Finds eigenvalues at each value of a parameter, mode by mode.
SweepRecord sweep_eigenvalues(const std::vector<double>& values,
                              const FindSweepState& find_state,
                              const SweepSettings& settings);

}  // namespace gxrod
