#pragma once

#include <vector>

#include "check/motions/unsupported_motions.hpp"

namespace gxrod {

// A part whose nodes rods tie to each other, and its rigid motions that nothing holds at t = 0.
struct FreePart {
    ModelPart part;
    std::vector<UnsupportedMotion> motions;  // at least one
};

// Parts that joints tie to each other, and what joints, motors, supports, springs and bushings leave them at
// t = 0.
struct FreeMechanism {
    ModelPart whole;
    std::size_t motions = 0;  // at least 1
    std::vector<int> joints;  // indices in Model::joints: those that move then
};

// What supports, springs and bushings leave free, of parts without joints. A spring or a bushing holds what
// its tangent resists; a spring a motion along its line and, where it pulls or pushes at t = 0, across it. A
// part that moves together with others by springs or bushings is listed with all of its share in such
// motions.
std::vector<FreePart> find_free_parts(const Model& model);

// Those that have free motions.
std::vector<FreeMechanism> find_free_mechanisms(const Model& model);

// How many motions of the whole model are free.
std::size_t count_free_motions(const Model& model);

}  // namespace gxrod
