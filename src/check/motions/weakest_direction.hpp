#pragma once

#include <optional>

#include "check/scaled_tangent.hpp"

namespace gxrod {

// A direction in which a model resists least.
struct WeakestDirection {
    Eigen::VectorXd scaled;  // in the unknowns of a ScaledTangent, of unit length
    double stiffness = 0.0;  // |K scaled|: about 1e-16 if K is singular
};

// The direction for which |K x| is smallest, by inverse iteration on KᵀK, K shifted by some 1e-15 so that it
// has an inverse. Where several directions are equally weak it is one of them. nullopt if K is not finite or
// has no unknowns.
std::optional<WeakestDirection> find_weakest_direction(const ScaledTangent& tangent);

}  // namespace gxrod
