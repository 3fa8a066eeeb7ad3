#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "model/parts.hpp"

namespace gxrod {

// A small motion of a part as a rigid body: point x moves by velocity + rotation × (x − point).
struct UnsupportedMotion {
    Vec3 velocity = Vec3::Zero();  // for a turn: along its axis, or zero
    Vec3 rotation = Vec3::Zero();  // unit vector, or zero for a translation
    Vec3 point = Vec3::Zero();     // on the axis of a turn, the nearest to the part's first support
    bool has_place = false;        // whether the axis of a turn is unique, not only its direction
};

struct PartExtent {
    Vec3 centre;
    double size;  // largest distance of a node from the centre; 1 for a point
};
PartExtent measure(const Model& model, const ModelPart& part);

// Builds a row for each component that supports hold; times (v, size · ω) of a rigid motion about the centre
// it is zero.
Eigen::MatrixXd build_support_rows(const Model& model, const ModelPart& part);

// Finds the rigid motions of a part that its supports leave free at t = 0: translations along directions of
// length 1, then turns; along the global axes if possible. Moved components are not free.
std::vector<UnsupportedMotion> find_unsupported_motions(const Model& model, const ModelPart& part);
// Finds the motions that given rows, as of build_support_rows, leave free.
std::vector<UnsupportedMotion> find_unsupported_motions(const Model& model,
                                                        const ModelPart& part,
                                                        const Eigen::MatrixXd& rows);

// Whether the part is one straight rod, on the axis of the turn.
bool is_twist(const Model& model, const ModelPart& part, const UnsupportedMotion& turn);

// Describes a motion: "move along x", "turn about an axis along (0, 0.6, 0.8) through (1, 2, 3)", "twist
// about its axis".
std::string describe_unsupported_motion(const Model& model,
                                        const ModelPart& part,
                                        const UnsupportedMotion& motion);

}  // namespace gxrod
