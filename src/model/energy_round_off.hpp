#pragma once

#include "model/model.hpp"

namespace gxrod {

// The strain energy that round-off of positions and rotations makes of no strain, and where supports move the
// work of the forces that it makes: an energy below it means nothing, nor does its failing to
// balance.
double compute_energy_round_off(const Model& model);

}  // namespace gxrod
