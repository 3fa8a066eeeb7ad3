#pragma once

#include <vector>

#include "constraints/step_differences.hpp"
#include "state/constraint_level.hpp"

namespace gxrod {

// How the equations of joints are asked for.
struct ConstraintRequest {
    ConstraintLevel level = ConstraintLevel::position;
    TimeSpan step{0.0, 0.0};  // within which motors are differentiated
    double factor = 1.0;  // by which the equations are multiplied: 1 over the linearization's acceleration
    double contact_weight = 1.0;  // of forces of contact; 0: they are left out
    // If given, D is that of these values of a tangent, so that differences of tangents have none of it.
    const std::vector<double>* scaled_as = nullptr;
    // If given, added to the tangent before D is chosen: its place is the system's pattern.
    const std::vector<double>* added = nullptr;
};

}  // namespace gxrod
