#pragma once

#include <string>

#include "model/model.hpp"
#include "model/settings/turning_frame.hpp"

namespace gxrod {

// Returns the reason why a model has no steady state in steady rotation, a sentence: what is not alike to all
// sides of the axis of a frame that turns, or of a part that spins. "" if a few load factors from 0 to 1, and
// a few places and velocities, show none.
std::string find_unsteady_action(const Model& model, const TurningFrame& frame);

}  // namespace gxrod
