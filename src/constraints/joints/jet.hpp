#pragma once

#include "constraints/joints/joint_motions.hpp"

// Quantities with their first two derivatives by time, docs/theory/joints.md (J2) to (J4). All spatial.
namespace gxrod {

template <class Value>
struct Jet {
    Value value, rate, acceleration;
};

using ScalarJet = Jet<double>;
using VectorJet = Jet<Vec3>;

// The product xᵀy of a vector and a vector or matrix, by Leibniz' rule.
template <class Product, class Value>
Jet<Product> multiply(const VectorJet& x, const Jet<Value>& y) {
    const auto times = [](const Vec3& p, const Value& q) -> Product { return p.transpose() * q; };
    return {times(x.value, y.value),
            times(x.rate, y.value) + times(x.value, y.rate),
            times(x.acceleration, y.value) + 2.0 * times(x.rate, y.rate) + times(x.value, y.acceleration)};
}

template <class Value>
Jet<Value> operator+(const Jet<Value>& x, const Jet<Value>& y) {
    return {x.value + y.value, x.rate + y.rate, x.acceleration + y.acceleration};
}

// Λ u, of a vector that a node carries; u in the global axes of t = 0.
VectorJet compute_carried(const NodeMotion& motion, const Vec3& u);

// The derivatives by δφ of a vector that a node carries, (J4).
Jet<Mat3> differentiate_carried(const VectorJet& carried,
                                const NodeMotion& motion,
                                const NodeLinearization& linearization);

}  // namespace gxrod
