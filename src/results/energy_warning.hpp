#pragma once

#include <string>

#include "state/energy_jump.hpp"

namespace gxrod {

// Largest energy and errors of a run over all its steps.
struct EnergySurvey {
    bool is_static = false;
    double largest = 0.0;        // kinetic and strain energy, or external work
    double largest_error = 0.0;  // largest error of the balance
    EnergyJumps jumps;           // jumps in a series of equilibria
};

// Returns a warning if energies are out of balance by more than round-off, so that results cannot be trusted:
// a clause that begins in lower case and has no full stop. Else "". In dynamics the largest error is above a
// tenth of the largest energy; in statics the structure jumps.
std::string describe_imbalance(const EnergySurvey& survey, double round_off);

}  // namespace gxrod
