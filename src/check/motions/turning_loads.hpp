#pragma once

#include <string>

#include "model/model.hpp"
#include "model/settings/turning_frame.hpp"

namespace gxrod {

// Returns the reason why a model has no steady state in a frame that turns, a sentence: a load, or gravity,
// is fixed in space and not along the axis. "" if a few load factors from 0 to 1 show none.
std::string find_unsteady_load(const Model& model, const TurningFrame& frame);

}  // namespace gxrod
