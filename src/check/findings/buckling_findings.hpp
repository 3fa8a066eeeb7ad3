#pragma once

#include <string>

#include "model/model.hpp"

namespace gxrod {

// Returns the reason why no load factor describes when this model buckles: some action is not multiplied by
// the factor, or no load could be multiplied. "" if there is no such reason.
std::string find_reason_against_factors(const Model& model);

// Returns why the reference shape has no factors if an obstacle moves on it: what it does is not proportional
// to its way. "" if none moves.
std::string find_moved_obstacle(const Model& model);

}  // namespace gxrod
