#pragma once

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

// Computes the energy of the elastic part.
double compute_bound_energy(const CoordinateLimits& limits, double depth);

}  // namespace gxrod
