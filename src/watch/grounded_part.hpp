#pragma once

#include <optional>
#include <span>

#include "model/model.hpp"
#include "state/motion.hpp"

namespace gxrod {

// An end of the part of a rod that lies on the ground.
struct TouchDown {
    double arc_length = 0.0;  // from the rod's start
    Vec3 position = Vec3::Zero();
};

// The first and the last place at which a rod touches the ground; between them it may hang free.
struct GroundedPart {
    TouchDown start, end;
};

// Finds where a rod lies on the ground: from a node that touches it to the next one that does not, the place
// where the surface of the element's interpolation is at the ground's height. nullopt if no node touches.
std::optional<GroundedPart> find_grounded_part(const Model& model,
                                               int rod,
                                               std::span<const NodeMotion> nodes);

}  // namespace gxrod
