#pragma once

#include "model/settings.hpp"
#include "verification/free_flight_problem.hpp"
#include "verification/study.hpp"

namespace gxrod::free_flight {

// Tip positions at t = 5 and what a run leaves behind.
struct Flight {
    Vec3 loaded_early, free_early;  // t = 2.5
    Vec3 loaded, free;              // t = 5
    double energy;                  // kinetic + strain at t = 5
    double energy_error;            // of the ledger, there
    Vec3 linear_momentum, angular_momentum;
    double iterations_per_step;
};

// Runs to t = 5; an even number of steps, so that t = 2.5 is one of them. Throws std::runtime_error if a step
// fails.
Flight fly(Pulse pulse, Scheme scheme, int elements, long steps);

// The largest distance of the four positions from the reference.
double compute_error(const Flight& flight, const Reference& reference);

// (1) Mesh and step refined together by (S), both pulses, against the reference. (2) The step alone refined
// by sdirk-4 on one mesh, against the next finer step. Orders must come out as 2 and 4.
StudyResult report(const StudyOptions& options);

}  // namespace gxrod::free_flight
