#pragma once

#include <string>

#include "model/model.hpp"
#include "model/settings/turning_frame.hpp"

namespace gxrod {

// Returns the reason why what spins about its own axis in a frame at rest has no steady state, a sentence:
// it, its loads or its ties are not alike to all sides of that axis. "" if there is none.
std::string find_unsteady_spin(const Model& model, const TurningFrame& frame);

}  // namespace gxrod
