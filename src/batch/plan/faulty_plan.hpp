#pragma once

#include <vector>

#include "batch/plan/plan.hpp"
#include "deck/text/fault.hpp"

namespace gxrod {

// Of a plan in which something is wrong already: what is wrong with its deck, and with the values and
// collections that could be read. Each value is examined in one case at least; combinations are not. None
// where the deck cannot be read.
std::vector<DeckFault> find_faults_of_cases(const Plan& plan);

}  // namespace gxrod
