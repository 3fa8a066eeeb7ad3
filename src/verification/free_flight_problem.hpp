#pragma once

#include "model/model.hpp"

// A flexible rod in free flight in space (Simo & Vu-Quoc 1988): 10 long, at rest from (6,0,0) to (0,8,0),
// driven at its start by the force (m/10, 0, 0) and the moment (0, −m/2, −m), then free.
namespace gxrod::free_flight {

enum class Pulse {
    triangular,  // 0–200–0 over t = 0–2.5–5, as published
    smooth       // 200 sin²(πt/5), t < 5, which shows the order of a scheme
};

double load(Pulse pulse, double time);
Model make_model(Pulse pulse, int elements);

// Positions of the loaded (start) and free (end) tips, and the energy and angular momentum that stay after t
// = 5.
struct Reference {
    Vec3 loaded_early, free_early;  // t = 2.5
    Vec3 loaded_late, free_late;    // t = 5
    double energy;
    double uncertainty;  // of positions
};

// The continuum's solution by spectral elements, with its uncertainty.
Reference reference(Pulse pulse);
// Impulse of the force: P after t = 5, exact.
Vec3 exact_momentum();
// H about the origin after t = 5, of the smooth pulse.
Vec3 reference_angular_momentum();

}  // namespace gxrod::free_flight
