#pragma once

#include <string>

#include "model/model.hpp"
#include "model/settings/turning_frame.hpp"

namespace gxrod {

// Why a model has no steady state in a frame that turns, a sentence: a load, or gravity, that is fixed in
// space and not along the axis. "" if there is none, as far as a few load factors from 0 to 1 show it.
std::string find_unsteady_load(const Model& model, const TurningFrame& frame);

}  // namespace gxrod
