#include "constraints/joints/cam_distance.hpp"

#include <algorithm>

namespace gxrod {

namespace {

using Kind = LinkVector::Kind;

// The distance has no derivatives at a centre of curvature; this near to it they are as large as here.
constexpr double nearest_centre = 1e-9;

}  // namespace

CamDistance::CamDistance(const Joint& joint)
    : cam_(*joint.cam), axes_{joint.a.axes.col(1), joint.a.axes.col(2)} {
    for (std::size_t i = 0; i < axes_.size(); ++i)
        along_[i] = LinkProduct({Kind::on_a, axes_[i]}, {Kind::separation});
}

Vec3 CamDistance::carry(const JointFrames& frames, const Point& direction) const {
    return frames.R_a * (direction.x() * axes_[0] + direction.y() * axes_[1]);
}

CamDistance::Point CamDistance::compute_point(const JointFrames& frames) const {
    const Vec3 separation = frames.R_a.transpose() * frames.separation.value;
    return {axes_[0].dot(separation), axes_[1].dot(separation)};
}

PlaneCurve::Place CamDistance::find_place(const JointFrames& frames) const {
    return cam_.curve->find_nearest(compute_point(frames));
}

Vec3 CamDistance::find_normal(const JointFrames& frames) const {
    return carry(frames, measure(compute_point(frames)).n);
}

CamDistance::Local CamDistance::measure(const Point& point) const {
    const PlaneCurve::Place place = cam_.curve->find_nearest(point);
    const Point& t = place.tangent;
    const Point n = cam_.side * Point(t.y(), -t.x());
    const double distance = n.dot(point - place.point);
    const double curvature = cam_.side * place.curvature;
    const double spread = std::max(1.0 + curvature * distance, nearest_centre);
    return {
        distance, n, t, curvature / spread, cam_.side * place.curvature_rate / (spread * spread * spread)};
}

Jet<CamDistance::Point> CamDistance::compute_jets(const JointFrames& frames) const {
    const ScalarJet x = along_[0].compute_jet(frames), y = along_[1].compute_jet(frames);
    return {{x.value, y.value}, {x.rate, y.rate}, {x.acceleration, y.acceleration}};
}

ScalarJet CamDistance::compute_jet(const JointFrames& frames) const {
    const Jet<Point> q = compute_jets(frames);
    const Local at = measure(q.value);
    const double slip = at.t.dot(q.rate);
    return {at.distance, at.n.dot(q.rate), at.n.dot(q.acceleration) + at.k * slip * slip};
}

void CamDistance::add_gradient(const JointFrames& frames, double factor, PairRow& row) const {
    const Local at = measure(compute_point(frames));
    for (std::size_t i = 0; i < along_.size(); ++i)
        along_[i].add_gradient(frames, factor * at.n[static_cast<Eigen::Index>(i)], row);
}

// With δn = k t (t · δq), δt = −k n (t · δq) and δk = k′ (t · δq) − k² (n · δq).
void CamDistance::add_change(const JointFrames& frames,
                             const JointLinearizations& linearizations,
                             const ScalarJet& weights,
                             PairRow& row) const {
    const Jet<Point> q = compute_jets(frames);
    const Local at = measure(q.value);
    const double slip = at.t.dot(q.rate), leave = at.n.dot(q.rate);
    const double along = weights.rate * at.k * slip +
                         weights.acceleration * (at.k * at.t.dot(q.acceleration) + at.k_along * slip * slip -
                                                 2.0 * at.k * at.k * leave * slip);
    const double across = weights.value - weights.acceleration * at.k * at.k * slip * slip;
    const Point of_value = across * at.n + along * at.t;
    const Point of_rate = weights.rate * at.n + 2.0 * weights.acceleration * at.k * slip * at.t;
    for (std::size_t i = 0; i < along_.size(); ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        along_[i].add_change(
            frames, linearizations, {of_value[axis], of_rate[axis], weights.acceleration * at.n[axis]}, row);
    }
}

void CamDistance::add_reaction(const JointFrames& frames, double multiplier, JointReaction& reaction) const {
    const Local at = measure(compute_point(frames));
    const Vec3 force = multiplier * carry(frames, at.n), t = carry(frames, at.t);
    reaction.force += force;
    reaction.carried += force;
    reaction.curving += multiplier * at.k * t * t.transpose();
}

}  // namespace gxrod
