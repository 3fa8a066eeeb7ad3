#pragma once

#include "rotation/types.hpp"
#include "state/constraint_level.hpp"

// Quantities with their first two derivatives by time, docs/theory/joints.md (J2) to (J4). All are spatial.
namespace gxrod {

template <class Value>
struct Jet {
    Value value, rate, acceleration;
};

using ScalarJet = Jet<double>;
using VectorJet = Jet<Vec3>;

// Returns the value or the derivative of this level.
inline double at_level(const ScalarJet& jet, ConstraintLevel level) {
    switch (level) {
        case ConstraintLevel::position:
            return jet.value;
        case ConstraintLevel::velocity:
            return jet.rate;
        default:
            return jet.acceleration;
    }
}

}  // namespace gxrod
