#pragma once

#include <optional>
#include <string>

#include "deck/places/build_context.hpp"

// Load cases and their combinations: [combination.NAME], one of which acts in a run.
namespace gxrod {

struct ActingTable;

// The case of gravity, if a combination names it.
inline constexpr const char* gravity_case = "gravity";

// Returns the factor of what acts in a case in the combination that acts: 1 without a case, and in a deck
// without combinations.
double find_case_factor(const std::optional<std::string>& load_case, const BuildContext& context);

// Reports the case of an action whose force is not proportional to anything, `what`, if its factor in the
// combination that acts is neither 0 nor 1.
void refuse_case_factor(const ActingTable& table, const std::string& what, const BuildContext& context);

// The factor of gravity: 1 unless some combination names it.
double find_gravity_factor(const BuildContext& context);

// Adds faults of names of cases and of the combination that acts, and notes what acts in which of them.
void check_combinations(BuildContext& context);

}  // namespace gxrod
