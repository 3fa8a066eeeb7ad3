#include "constraints/joints/play/bound_push.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

double compute_elastic(const CoordinateLimits& limits, double depth) {
    return limits.exponent == 1.0 ? limits.stiffness * depth
                                  : limits.stiffness * std::pow(depth, limits.exponent);
}

// The derivative of the elastic part.
double compute_slope(const CoordinateLimits& limits, double depth) {
    return limits.exponent == 1.0
               ? limits.stiffness
               : limits.stiffness * limits.exponent * std::pow(depth, limits.exponent - 1.0);
}

}  // namespace

BoundPush compute_bound_push(const CoordinateLimits& limits, double depth, double rate) {
    BoundPush push;
    push.elastic = compute_elastic(limits, depth);
    push.force = push.elastic + (limits.damping + limits.hysteresis * push.elastic) * rate;
    if (push.force <= 0.0) {
        push.force = 0.0;
        return push;
    }
    push.by_depth = compute_slope(limits, depth) * (1.0 + limits.hysteresis * rate);
    push.by_rate = limits.damping + limits.hysteresis * push.elastic;
    return push;
}

LimitPush compute_limit_push(const CoordinateLimits& limits, const ScalarJet& coordinate) {
    LimitPush push;
    if (limits.upper && coordinate.value > *limits.upper)
        push = {coordinate.value - *limits.upper, coordinate.rate, -1.0};
    else if (limits.lower && coordinate.value < *limits.lower)
        push = {*limits.lower - coordinate.value, -coordinate.rate, 1.0};
    push.push = compute_bound_push(limits, push.depth, push.rate);
    return push;
}

// Where a fast return leaves no push, what the bound releases is lost: only the way beyond the bounds counts.
double compute_limit_loss(const CoordinateLimits& limits, const ScalarJet& before, const ScalarJet& after) {
    const LimitPush first = compute_limit_push(limits, before);
    const LimitPush last = compute_limit_push(limits, after);
    const double movement = after.value - before.value;
    const double beyond = first.direction * first.depth - last.direction * last.depth;
    double loss = 0.0;
    for (const LimitPush& end : {first, last}) {
        const double damping = end.direction * (end.push.force - end.push.elastic);
        loss -= 0.5 * damping * (end.push.force > 0.0 ? movement : beyond);
    }
    return std::max(loss, 0.0);
}

double compute_coordinate_damping_action(const JointCoordinate& laws,
                                         const ScalarJet& before,
                                         const ScalarJet& after,
                                         double time_step) {
    const double movement = after.value - before.value;
    return laws.damping * movement * movement + time_step * compute_limit_loss(laws.limits, before, after);
}

double compute_bound_energy(const CoordinateLimits& limits, double depth) {
    return compute_elastic(limits, depth) * depth / (limits.exponent + 1.0);
}

}  // namespace gxrod
