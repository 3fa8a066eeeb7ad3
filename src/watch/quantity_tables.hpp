#pragma once

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
};

extern const QuantityTable quantities_of_places, quantities_of_rod_turns, quantities_of_body_turns;
extern const QuantityTable quantities_of_rates, quantities_of_bodies, quantities_of_reactions;
extern const QuantityTable quantities_of_sections;
extern const QuantityTable quantities_of_springs, quantities_of_bushings, quantities_of_tendons;
extern const QuantityTable quantities_of_joints, quantities_of_gears;
extern const QuantityTable quantities_of_rods_around, quantities_of_bodies_around;
extern const QuantityTable quantities_of_obstacles;
extern const QuantityTable quantities_of_touching_rods, quantities_of_touching_bodies;

}  // namespace gxrod
