#pragma once

#include <optional>

#include "check/scaled_tangent.hpp"

namespace gxrod {

// A direction of least stiffness.
struct WeakestDirection {
    Eigen::VectorXd scaled;  // in the unknowns of a ScaledTangent, of unit length
    double stiffness = 0.0;  // |K scaled|: about 1e-16 if K is singular
};

// Finds the direction with the smallest |K x|, by inverse iteration on KᵀK, with K shifted by some 1e-15 so
// that it has an inverse. If several directions are equally weak it is one of them. Returns nullopt if K is
// not finite or has no unknowns.
std::optional<WeakestDirection> find_weakest_direction(const ScaledTangent& tangent);

}  // namespace gxrod
