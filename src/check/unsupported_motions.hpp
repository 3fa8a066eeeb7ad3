#pragma once

#include <string>
#include <vector>

#include "model/parts.hpp"

namespace gxrod {

// A small motion of a part as a rigid body: point x moves by velocity + rotation × (x − point).
struct UnsupportedMotion {
    Vec3 velocity = Vec3::Zero();  // of a turn: along its axis, or zero
    Vec3 rotation = Vec3::Zero();  // of length 1, or zero for a translation
    Vec3 point = Vec3::Zero();     // on the axis of a turn, the nearest to the part's first support
    bool has_place = false;        // whether the axis of a turn cannot be anywhere else, parallel to itself
};

// The rigid motions of a part that its supports leave free at t = 0: translations along directions of length
// 1, then turns; along the global axes where that is possible. Moved components are not free.
std::vector<UnsupportedMotion> find_unsupported_motions(const Model& model, const ModelPart& part);

// "move along x", "turn about an axis along (0, 0.6, 0.8) through (1, 2, 3)", "twist about its axis".
std::string describe_unsupported_motion(const Model& model,
                                        const ModelPart& part,
                                        const UnsupportedMotion& motion);

}  // namespace gxrod
