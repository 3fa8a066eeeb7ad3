#include "constraints/supports.hpp"

#include <cassert>

#include "rotation/rates.hpp"
#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

namespace {

constexpr int stencil_size = 7;
using Stencil = std::array<double, stencil_size>;

// Derivatives from seven equally spaced values, exact for polynomials of degree 6 (Fornberg 1988).
struct DifferenceRule {
    int first;  // of the points, in steps
    Stencil slope, curvature;
};

constexpr DifferenceRule after{
    0,
    {-49.0 / 20.0, 6.0, -15.0 / 2.0, 20.0 / 3.0, -15.0 / 4.0, 6.0 / 5.0, -1.0 / 6.0},
    {203.0 / 45.0, -87.0 / 5.0, 117.0 / 4.0, -254.0 / 9.0, 33.0 / 2.0, -27.0 / 5.0, 137.0 / 180.0}};
constexpr DifferenceRule central{
    -3,
    {-1.0 / 60.0, 3.0 / 20.0, -3.0 / 4.0, 0.0, 3.0 / 4.0, -3.0 / 20.0, 1.0 / 60.0},
    {1.0 / 90.0, -3.0 / 20.0, 3.0 / 2.0, -49.0 / 18.0, 3.0 / 2.0, -3.0 / 20.0, 1.0 / 90.0}};

// Three components of a support's motion, from `first` on; zero where it does not move. In its own axes.
Vec3 motion_at(const Support& support, int first, double time) {
    Vec3 value = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        if (support.moved[first + i]) value[i] = support.motion[first + i](time);
    }
    return value;
}

struct Derivatives {
    Vec3 slope = Vec3::Zero();
    Vec3 curvature = Vec3::Zero();
};

Derivatives differentiate(
    const Support& support, int first, double time, double step, const DifferenceRule& rule) {
    Derivatives derivatives;
    for (int k = 0; k < stencil_size; ++k) {
        const Vec3 value = motion_at(support, first, time + (rule.first + k) * step);
        derivatives.slope += (rule.slope[k] / step) * value;
        derivatives.curvature += (rule.curvature[k] / (step * step)) * value;
    }
    return derivatives;
}

bool moves(const Support& support, int first) {
    return support.moved[first] || support.moved[first + 1] || support.moved[first + 2];
}

}  // namespace

Supports::Supports(const Model& model)
    : model_(&model), held_(model.nodes.size(), HeldComponents{}), own_axes_(model.nodes.size(), -1) {
    for (const Support& support : model.supports) {
        for (int i = 0; i < 6; ++i) {
            held_[support.node][i] = held_[support.node][i] || support.holds(i);
        }
        if (!support.axes.isApprox(Quat::Identity(), 0.0)) {
            own_axes_[support.node] = static_cast<int>(axes_.size()) - 1;
            axes_.push_back(support.axes.toRotationMatrix());
        }
        if (moves(support, 0) || moves(support, 3)) moving_.push_back(&support);
    }
}

void Supports::place_position(const Support& support, double time, NodeMotion& motion) const {
    const Mat3& Q = axes(support.node);
    const Vec3& reference = model_->nodes[support.node].position;
    const Vec3 wanted = motion_at(support, 0, time);
    Vec3 displacement = Q.transpose() * (motion.r - reference);
    for (int i = 0; i < 3; ++i) {
        if (support.holds(i)) displacement[i] = wanted[i];
    }
    motion.r = reference + Q * displacement;
}

void Supports::place_rotation(const Support& support, double time, State& state) const {
    const Mat3& Q = axes(support.node);
    const NodeMotion& previous = state.previous[support.node];
    NodeMotion& trial = state.trial[support.node];
    const Vec3 phi = Q * motion_at(support, 3, time);
    const Vec3 change = phi - Q * motion_at(support, 3, state.time);
    // A long φ that leans turns much less than it changes: ω = T(φ) φ̇.
    const Vec3 guess = tangent_map(phi - 0.5 * change) * change;
    trial.Lambda = exp_quaternion(phi);
    trial.theta = log_nearest(trial.Lambda * previous.Lambda.conjugate(), guess);
}

void Supports::place(double time, State& state) const {
    for (const Support* support : moving_) {
        if (moves(*support, 0)) place_position(*support, time, state.trial[support->node]);
        if (moves(*support, 3)) place_rotation(*support, time, state);
    }
}

void Supports::set_rates(double time, double step, Side side, std::vector<NodeMotion>& motions) const {
    const DifferenceRule& rule = side == Side::after ? after : central;
    for (const Support* support : moving_) {
        const Mat3& Q = axes(support->node);
        NodeMotion& motion = motions[support->node];
        if (moves(*support, 0)) {
            const Derivatives rates = differentiate(*support, 0, time, step, rule);
            Vec3 v = Q.transpose() * motion.v;
            Vec3 a = Q.transpose() * motion.a;
            for (int i = 0; i < 3; ++i) {
                if (!support->moved[i]) continue;
                v[i] = rates.slope[i];
                a[i] = rates.curvature[i];
            }
            motion.v = Q * v;
            motion.a = Q * a;
        }
        if (moves(*support, 3)) {
            const Derivatives rates = differentiate(*support, 3, time, step, rule);
            const Vec3 phi = Q * motion_at(*support, 3, time);
            motion.omega = angular_velocity(phi, Q * rates.slope);
            motion.alpha = angular_acceleration(phi, Q * rates.slope, Q * rates.curvature);
        }
    }
}

}  // namespace gxrod
