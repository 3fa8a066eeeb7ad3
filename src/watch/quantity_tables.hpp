#pragma once

#include <array>
#include <span>

#include "watch/sight.hpp"

// The quantities of all things, a line each. A kind of thing has the lines of one or several tables
// (watch/quantities.cpp).
namespace gxrod {

// The part of a snapshot that quantities read, which has to be computed for them.
enum class SnapshotPart { motion, section, reactions, ties, contact };

struct QuantityTable {
    std::span<const Quantity> lines;
    SnapshotPart part;
    const char* owners;  // "springs", for other things that are asked for these quantities
    // Why a thing whose first table this is does not have a quantity of others; "" where that depends.
    const char* own = "";
};

extern const QuantityTable quantities_of_places, quantities_of_rod_turns, quantities_of_body_turns;
extern const QuantityTable quantities_of_rates, quantities_of_bodies, quantities_of_reactions;
extern const QuantityTable quantities_of_sections, quantities_of_stresses;
extern const QuantityTable quantities_of_tendons, quantities_of_joints, quantities_of_gears;
// The quantities of ties, kind by kind.
extern const std::array<const QuantityTable*, tie_kind_count> quantities_of_ties;
extern const QuantityTable quantities_of_rods_around, quantities_of_bodies_around;
extern const QuantityTable quantities_of_lying_rods;
extern const QuantityTable quantities_of_obstacles;
extern const QuantityTable quantities_of_touching_rods, quantities_of_touching_bodies;

// Returns whether a word is one of those of stresses.
bool is_stress_quantity(std::string_view word);

}  // namespace gxrod
