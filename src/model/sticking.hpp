#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

// Friction at its limit, whether it sticks or slips (docs/theory/laws.md, (L29)).
namespace gxrod {

// Lists everything with friction: "joint knee", "tendon pull", "the seabed", "contact".
std::vector<std::string> list_frictions(const Model& model);

// Returns the model with limits of friction, all or only the listed one, changed so little that no force
// changes: friction at its limit then sticks, or slips.
enum class AtLimit { sticks, slips };
Model set_at_limit(Model model, AtLimit then);
Model set_at_limit(Model model, AtLimit then, const std::string& listed);

}  // namespace gxrod
