#pragma once

#include <vector>

#include "check/motions/unsupported_motions.hpp"

namespace gxrod {

// A part whose nodes rods couple to each other, and its unsupported rigid motions at t = 0.
struct FreePart {
    ModelPart part;
    std::vector<UnsupportedMotion> motions;  // at least one
};

// Parts coupled by joints, and the motions that joints, motors, supports, springs and bushings leave free at
// t = 0.
struct FreeMechanism {
    ModelPart whole;
    std::size_t motions = 0;  // at least 1
    std::vector<int> joints;  // joints that move in these motions, indices in Model::joints
};

// Finds the motions that supports, springs and bushings leave free, for parts without joints. A spring or a
// bushing holds motions that its tangent resists; a spring holds a motion along its line and, if it is under
// force at t = 0, across it. A part that moves together with others by springs or bushings is listed with its
// whole share in such motions.
std::vector<FreePart> find_free_parts(const Model& model);

// Finds the mechanisms that have free motions.
std::vector<FreeMechanism> find_free_mechanisms(const Model& model);

// Counts the free motions of the whole model.
std::size_t count_free_motions(const Model& model);

}  // namespace gxrod
