#pragma once

#include <string>

#include "deck/output/history_place.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// Why the point has no such quantity, or "".
std::string explain_missing(Quantity quantity, const HistoryPlace& point, const Model& model);

// '; did you mean "axial_force"?', of what the point has instead of a word that means something else
// elsewhere; "" if nothing is meant.
std::string suggest_quantity(const std::string& word, const HistoryPlace& point, const Model& model);

// Of contact.
bool is_of_obstacles(Quantity quantity);
// Whether the point is that of a body that touches.
bool touches(const HistoryPlace& point, const Model& model);

// Whether the quantity can be relative to another point.
bool can_be_relative(Quantity quantity);

}  // namespace gxrod
