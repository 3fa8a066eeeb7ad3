#pragma once

#include <nlohmann/json_fwd.hpp>

#include "deck/problem.hpp"

namespace gxrod {

// Describes the rods in fluids, for the tension in their walls, and where pressures act, the data on which
// they depend.
nlohmann::ordered_json describe_wet_rods(const Problem& problem);

}  // namespace gxrod
