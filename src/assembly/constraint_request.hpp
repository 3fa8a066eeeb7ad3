#pragma once

#include <vector>

#include "constraints/step_differences.hpp"
#include "state/constraint_level.hpp"

namespace gxrod {

// Which stops hold: those that the multipliers ask for in equations of positions, and those that held at the
// start of the step in equations of accelerations (by_level); those in both (as_before); or those that are
// closed at the end of the step (at_end).
enum class StopChoice { by_level, as_before, at_end };

// Options for contributions to a residual or tangent.
struct ConstraintRequest {
    ConstraintLevel level = ConstraintLevel::position;
    TimeSpan step{0.0, 0.0};      // motors are differentiated within it
    double factor = 1.0;          // multiplies the equations: 1 over the linearization's acceleration
    double contact_weight = 1.0;  // weight of contact forces; 0 leaves them out
    // If given, D comes from these values of a tangent, so that it drops out of differences of tangents.
    const std::vector<double>* scaled_as = nullptr;
    // If given, these values on the system's pattern are added to the tangent before D is chosen.
    const std::vector<double>* added = nullptr;
    StopChoice stops = StopChoice::by_level;
};

}  // namespace gxrod
