#pragma once

#include <nlohmann/json_fwd.hpp>

#include "deck/problem.hpp"

namespace gxrod {

// Of rods in fluids, for the tension in their walls: which they are, and where pressures act, what they
// depend on.
nlohmann::ordered_json describe_wet_rods(const Problem& problem);

}  // namespace gxrod
