#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

// Friction at its limit, which sticks or slips (docs/theory/laws.md, (L29)).
namespace gxrod {

// Lists what has friction of its own: "joint knee", "tendon pull", "the seabed", "contact".
std::vector<std::string> list_frictions(const Model& model);

// Moves limits of friction, of all or of the one listed so, by so little that no force changes: what is at
// its limit sticks, or slips.
enum class AtLimit { sticks, slips };
Model set_at_limit(Model model, AtLimit then);
Model set_at_limit(Model model, AtLimit then, const std::string& listed);

}  // namespace gxrod
