#include "check/mechanism/joint_gradient.hpp"

#include "constraints/joints/gear_rows.hpp"
#include "constraints/joints/sleeve_rows.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {
namespace {

constexpr double round_off = 1e-12;

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
    const JointRows rows(joint);
    JointMatrix gradient = rows.compute_gradient({a, b});
    for (int row = 0; row < rows.count(); ++row) {
        if (rows.is_stop(row) && rows.find_stop(row, {a, b}, 0.0).gap > round_off)
            gradient.row(row).setZero();
    }
    return gradient;
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

WideGradient compute_slide_gradient(const Model& model, int sleeve) {
    Model moved = model;
    moved.sleeves[static_cast<std::size_t>(sleeve)].slide.motion = TimeFunction(0.0);
    const SleeveRows rows(moved, moved.sleeves[static_cast<std::size_t>(sleeve)]);
    WideGradient gradient = compute_start_gradient(moved, rows);
    gradient.rows = gradient.rows.middleRows(SleeveMotion::slide, 1).eval();
    return gradient;
}

WideGradient compute_mesh_gradient(const Model& model, int gear) {
    Gear rigid = model.gears[static_cast<std::size_t>(gear)];
    rigid.teeth.reset();
    return compute_start_gradient(model, GearRows(model, rigid));
}

WideGradient compute_start_gradient(const Model& model, const WideRows& rows) {
    State state;
    for (const Node& node : model.nodes) state.previous.emplace_back().r = node.position;
    // Everything is 0 at the start, for whatever the rows look up.
    state.joints_previous.resize(count_numbered_ties(model));
    const WidePlace start{state.previous, state, JointState{}, {}, 0.0};
    return {rows.list_nodes(start), rows.compute_gradient(start)};
}

}  // namespace gxrod
