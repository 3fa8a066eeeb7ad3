#pragma once

#include <vector>

#include "batch/plan/plan.hpp"
#include "deck/text/fault.hpp"

namespace gxrod {

// Finds further faults of a plan with faults: in its deck, and in the values and collections that could be
// read. Each value is examined in at least one case; combinations are not. None if the deck cannot be read.
std::vector<DeckFault> find_faults_of_cases(const Plan& plan);

}  // namespace gxrod
