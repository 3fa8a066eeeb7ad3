#pragma once

#include <string>

#include "state/energy_jump.hpp"

namespace gxrod {

// What is known of the energies of a run, over all its steps.
struct EnergySurvey {
    bool is_static = false;
    double largest = 0.0;        // kinetic and strain energy, or external work
    double largest_error = 0.0;  // of the balance
    EnergyJumps jumps;           // of a series of equilibria
};

// What to say where energies do not balance by more than is round-off, so that results are not to be trusted:
// a clause that begins in lower case and has no full stop. Else "". In dynamics the largest error is above a
// tenth of the largest energy; in statics the structure jumps.
std::string describe_imbalance(const EnergySurvey& survey, double round_off);

}  // namespace gxrod
