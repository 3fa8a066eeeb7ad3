#pragma once

#include "model/model.hpp"

namespace gxrod {

// Computes the strain energy that round-off of positions and rotations causes and, if supports move, the work
// of the resulting forces: smaller energies and imbalances mean nothing.
double compute_energy_round_off(const Model& model);

}  // namespace gxrod
