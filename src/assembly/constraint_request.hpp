#pragma once

#include <vector>

#include "constraints/step_differences.hpp"
#include "state/constraint_level.hpp"

namespace gxrod {

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
};

}  // namespace gxrod
