#pragma once

#include <string>

#include "model/model.hpp"

namespace gxrod {

// Returns the reason why no load factor describes when this model buckles: some action is not multiplied by
// the factor, or no load could be multiplied. "" if there is no such reason.
std::string find_reason_against_factors(const Model& model);

}  // namespace gxrod
