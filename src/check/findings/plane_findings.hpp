#pragma once

#include <string>

#include "model/model.hpp"

namespace gxrod {

// Describes, for a model that the deck keeps in a plane, a load that pushes out of it; "" if there is none.
std::string find_push_out_of_plane(const Model& model);

// Suggests a plane for a model in space that lies, is loaded and is held in a plane of two axes, so that it
// could be solved with half of the unknowns; "" if it does not.
std::string suggest_plane(const Model& model);

}  // namespace gxrod
