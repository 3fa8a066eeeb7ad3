#pragma once

#include <optional>
#include <span>
#include <vector>

#include "deck/places/build_context.hpp"

// What carries the two points of a spring, a bushing or a joint: the words of its key `between`.
namespace gxrod {

// The word for what does not move.
inline constexpr const char* ground_word = "ground";

const std::vector<CheckedWord>& ends_of(const CheckedTable& table);

// The point that between[index] names, where the key `place_key` says, or else its node is. nullopt if it
// names no point; the ground without a place is a fault.
std::optional<Anchor> find_anchor(const CheckedTable& table,
                                  std::size_t index,
                                  const char* place_key,
                                  const BuildContext& context);

// The diagonal of the box around all nodes and these points.
double measure_size(const Model& model, std::span<const Anchor> anchors);

}  // namespace gxrod
