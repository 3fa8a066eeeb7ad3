#include "check/mechanism/joint_gradient.hpp"

namespace gxrod {
namespace {

// At rest in the places of t = 0; the ground is at the origin.
NodeMotion start_of(const Model& model, const Anchor& anchor) {
    NodeMotion motion;
    if (!anchor.is_ground()) motion.r = model.nodes[anchor.node].position;
    return motion;
}

}  // namespace

JointMatrix compute_start_gradient(const Model& model, const Joint& joint) {
    const NodeMotion a = start_of(model, joint.a.anchor);
    const NodeMotion b = start_of(model, joint.b.anchor);
    return JointRows(joint).compute_gradient({a, b});
}

Eigen::Matrix<double, Eigen::Dynamic, 12> compute_coordinate_gradients(const Model& model,
                                                                       const Joint& joint) {
    const NodeMotion a = start_of(model, joint.a.anchor);
    const NodeMotion b = start_of(model, joint.b.anchor);
    const JointCoordinates coordinates(joint);
    Eigen::Matrix<double, Eigen::Dynamic, 12> rows(int(joint.has_turn()) + int(joint.has_slide()), 12);
    if (coordinates.turn) rows.row(0) = coordinates.turn->compute_gradient({a, b});
    if (coordinates.slide) rows.bottomRows<1>() = coordinates.slide->compute_gradient({a, b});
    return rows;
}

}  // namespace gxrod
