#pragma once

#include <string>

#include "model/model.hpp"

namespace gxrod {

// Why no factor on what acts says when this model gives way: something acts that the factor would leave out,
// or nothing acts that it could multiply. "" if there is no such reason.
std::string find_reason_against_factors(const Model& model);

}  // namespace gxrod
