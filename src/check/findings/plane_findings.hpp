#pragma once

#include <string>

#include "model/model.hpp"

namespace gxrod {

// Of a model that the deck keeps in a plane: what pushes out of it, as a sentence; "" if nothing does.
std::string find_push_out_of_plane(const Model& model);

// Of a model in space: that all of it lies, is loaded and is held in a plane of two axes of space, and would
// be solved with half of the unknowns there; "" if not.
std::string suggest_plane(const Model& model);

}  // namespace gxrod
