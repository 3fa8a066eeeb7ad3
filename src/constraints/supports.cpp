#include "constraints/supports.hpp"

#include <cassert>

#include "rotation/rates.hpp"
#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

namespace {

constexpr double same_rotation = 1e-9;

// Three components of a support's motion, from `first` on; zero where it does not move. In its own axes.
Vec3 motion_at(const Support& support, int first, double time) {
    Vec3 value = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        if (support.moved[first + i]) value[i] = support.motion[first + i](time);
    }
    return value;
}

bool moves(const Support& support, int first) {
    return support.moved[first] || support.moved[first + 1] || support.moved[first + 2];
}

bool holds_position(const Support& support) {
    return support.holds(0) || support.holds(1) || support.holds(2);
}

struct Derivatives {
    Vec3 first = Vec3::Zero();
    Vec3 second = Vec3::Zero();
};

// Of three components of a support's motion; zero where it does not move.
Derivatives differentiate(const Support& support, int first, const StepDifferences& differences) {
    Derivatives derivatives;
    if (!moves(support, first)) return derivatives;
    for (int k = 0; k < difference_points; ++k) {
        const Vec3 value = motion_at(support, first, differences.times[k]);
        derivatives.first += differences.first[k] * value;
        derivatives.second += differences.second[k] * value;
    }
    return derivatives;
}

// Puts those components of a position or its rate that the support holds to what is wanted in its axes.
void replace_held(const Support& support, const Mat3& axes, const Vec3& wanted, Vec3& value) {
    if (!holds_position(support)) return;
    Vec3 own = axes.transpose() * value;
    for (int i = 0; i < 3; ++i) {
        if (support.holds(i)) own[i] = wanted[i];
    }
    value = axes * own;
}

}  // namespace

Supports::Supports(const Model& model)
    : model_(&model), held_(model.nodes.size(), HeldComponents{}), own_axes_(model.nodes.size(), -1) {
    if (model.plane) {
        // Where there is a support, it holds these, too, in its own axes.
        HeldComponents held{};
        for (int i = 0; i < 6; ++i) held[i] = model.plane->holds(i);
        held_.assign(held_.size(), held);
        for (const Support& support : model.supports) held_[support.node] = {};
    }
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
    Vec3 displacement = motion.r - reference;
    replace_held(support, Q, motion_at(support, 0, time), displacement);
    motion.r = reference + displacement;
}

void Supports::place_rotation(const Support& support, double time, State& state) const {
    const Mat3& Q = axes(support.node);
    const NodeMotion& previous = state.previous[support.node];
    NodeMotion& trial = state.trial[support.node];
    const Vec3 phi = Q * motion_at(support, 3, time);
    Vec3 last = Q * motion_at(support, 3, state.time);
    // At the start of a deck nothing is turned yet, also where a static move begins with a jump.
    const bool is_there = previous.Lambda.angularDistance(exp_quaternion(last)) < same_rotation;
    if (state.time == 0.0 && !is_there) last.setZero();
    const Vec3 change = phi - last;
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

void Supports::set_rates(double time, const TimeSpan& step, std::vector<NodeMotion>& motions) const {
    StepDifferences differences{};  // of what does not move none are needed
    if (move()) differences = compute_step_differences(time, step);
    for (const Support& support : model_->supports) {
        const Mat3& Q = axes(support.node);
        NodeMotion& motion = motions[support.node];
        const Derivatives of_position = differentiate(support, 0, differences);
        replace_held(support, Q, of_position.first, motion.v);
        const Derivatives of_rotation = differentiate(support, 3, differences);
        if (moves(support, 3)) {
            const Vec3 phi = Q * motion_at(support, 3, time);
            motion.omega = angular_velocity(phi, Q * of_rotation.first);
            if (model_->has_inertia)
                motion.alpha = angular_acceleration(phi, Q * of_rotation.first, Q * of_rotation.second);
        } else if (support.holds_all(3)) {
            motion.omega.setZero();
            motion.alpha.setZero();
        }
        if (model_->has_inertia) replace_held(support, Q, of_position.second, motion.a);
    }
}

}  // namespace gxrod
