#include "constraints/joints/play/bound_push.hpp"

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

double compute_bound_energy(const CoordinateLimits& limits, double depth) {
    return compute_elastic(limits, depth) * depth / (limits.exponent + 1.0);
}

}  // namespace gxrod
