#pragma once

#include "constraints/joints/jet.hpp"
#include "model/joint.hpp"

namespace gxrod {

// The push of a bound at a depth beyond it, (J17): stiffness gⁿ (1 + hysteresis ġ) + damping ġ, never
// negative, with its elastic part and its derivatives.
struct BoundPush {
    double force = 0.0;
    double elastic = 0.0;
    double by_depth = 0.0;
    double by_rate = 0.0;
};

// Computes the push for a depth that is not negative.
BoundPush compute_bound_push(const CoordinateLimits& limits, double depth, double rate);

// How far a coordinate is beyond one of its bounds, at which rate, and what pushes it back; nothing pulls.
struct LimitPush {
    double depth = 0.0;
    double rate = 0.0;
    double direction = 0.0;  // of the push, along the coordinate
    BoundPush push{};        // towards the inside
};
LimitPush compute_limit_push(const CoordinateLimits& limits, const ScalarJet& coordinate);

// Computes the dissipation of the bounds between the two ends of a step; never negative. The force is not
// linear in the rate, because it never pulls: the means of the forces at both ends count, (E15).
double compute_limit_loss(const CoordinateLimits& limits, const ScalarJet& before, const ScalarJet& after);

// Computes the dissipation in a step, times its length, of a coordinate's damper and of its bounds.
double compute_coordinate_damping_action(const JointCoordinate& laws,
                                         const ScalarJet& before,
                                         const ScalarJet& after,
                                         double time_step);

// Computes the energy of the elastic part.
double compute_bound_energy(const CoordinateLimits& limits, double depth);

}  // namespace gxrod
