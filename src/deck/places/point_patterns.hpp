#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "deck/places/build_context.hpp"
#include "deck/table/place_kinds.hpp"

// The points of keys that name several: lists, patterns, and conditions on the place.
namespace gxrod {

// Finds the points that `at` names, those that satisfy `where` if that is given, each node once; without
// `at` those of all rods. A rod that `at` names stands for its ends, its corners, and the nodes between the
// elements of its mesh. Adds a fault if no point is left, but not for a text without a point, which
// check_points reports.
std::vector<PlacedPoint> find_points(const TableHead& table,
                                     const std::optional<PointPatterns>& at,
                                     const std::optional<PlaceCondition>& where,
                                     const BuildContext& context);

// Returns whether the tangent of a rod jumps where the element begins whose first entry in
// Rod::element_nodes this is.
bool is_corner(const Rod& rod, std::size_t entry);

// Selects the elements of a rod whose middle satisfies a condition, by index.
std::vector<bool> select_elements(const Rod& rod, const PlaceCondition& where, const BuildContext& context);

}  // namespace gxrod
