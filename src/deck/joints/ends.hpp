#pragma once

#include <optional>
#include <span>
#include <vector>

#include "deck/places/build_context.hpp"

// The ends of a spring, a bushing or a joint, from the words of its key `between`.
namespace gxrod {

// The word for the ground, which does not move.
inline constexpr const char* ground_word = "ground";

// Finds the point of an end: at the place that a field of the table gives, or else at its node. nullopt if
// there is no such point; the ground without a place is a fault.
std::optional<Anchor> find_anchor(const TableHead& table,
                                  const CheckedWord& end,
                                  const std::optional<Vec3>& place,
                                  const BuildContext& context);

// Returns the diagonal of the box around all nodes and these points.
double measure_size(const Model& model, std::span<const Anchor> anchors);

}  // namespace gxrod
