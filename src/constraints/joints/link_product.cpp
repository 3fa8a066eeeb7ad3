#include "constraints/joints/link_product.hpp"

#include "rotation/cross_products.hpp"

namespace gxrod {

namespace {

Vec3 compute_value(const LinkVector& u, const JointMotions& motions) {
    return u.in_space + motions.a.Lambda * u.on_a + motions.b.Lambda * u.on_b +
           u.span * (motions.b.r - motions.a.r);
}

VectorJet compute_vector_jet(const LinkVector& u, const JointMotions& motions) {
    const auto& [a, b] = motions;
    const VectorJet rest{u.in_space + u.span * (b.r - a.r), u.span * (b.v - a.v), u.span * (b.a - a.a)};
    return rest + compute_carried(a, u.on_a) + compute_carried(b, u.on_b);
}

// ∂u/∂(δr, δφ).
PairJacobian compute_jacobian(const LinkVector& u, const JointMotions& motions) {
    PairJacobian jacobian;
    jacobian << -u.span * Mat3::Identity(), -cross_matrix<double>(motions.a.Lambda * u.on_a),
        u.span * Mat3::Identity(), -cross_matrix<double>(motions.b.Lambda * u.on_b);
    return jacobian;
}

// Adds gᵀ ∂u/∂(δr, δφ).
void add_pulled_back(const LinkVector& u, const Vec3& g, const JointMotions& motions, PairRow& row) {
    row.segment<3>(0) -= u.span * g;
    row.segment<3>(3) += (motions.a.Lambda * u.on_a).cross(g);
    row.segment<3>(6) += u.span * g;
    row.segment<3>(9) += (motions.b.Lambda * u.on_b).cross(g);
}

// Adds the derivative of (gᵀ ∂u/∂(δr, δφ))ᵀ at fixed g: that of the moments (Λu₀) × g.
void add_turned(const LinkVector& u, const Vec3& g, const JointMotions& motions, PairMatrix& matrix) {
    matrix.block<3, 3>(3, 3) += cross_columns(g, cross_matrix<double>(motions.a.Lambda * u.on_a));
    matrix.block<3, 3>(9, 9) += cross_columns(g, cross_matrix<double>(motions.b.Lambda * u.on_b));
}

// The derivatives of u, u̇, ü by Newton's unknowns.
Jet<PairJacobian> differentiate_vector(const LinkVector& u,
                                       const JointMotions& motions,
                                       const JointLinearizations& linearizations) {
    const auto& [a, b] = linearizations;
    const auto on_a = differentiate_carried(compute_carried(motions.a, u.on_a), motions.a, a);
    const auto on_b = differentiate_carried(compute_carried(motions.b, u.on_b), motions.b, b);
    const Mat3 span = u.span * Mat3::Identity();
    Jet<PairJacobian> jet;
    jet.value << -a.placement * span, on_a.value, b.placement * span, on_b.value;
    jet.rate << -a.rate * span, on_a.rate, b.rate * span, on_b.rate;
    jet.acceleration << -a.acceleration * span, on_a.acceleration, b.acceleration * span, on_b.acceleration;
    return jet;
}

}  // namespace

ScalarJet LinkProduct::compute_jet(const JointMotions& motions) const {
    return multiply<double>(compute_vector_jet(first_, motions), compute_vector_jet(second_, motions));
}

PairRow LinkProduct::compute_gradient(const JointMotions& motions) const {
    PairRow gradient = PairRow::Zero();
    add_pulled_back(first_, compute_value(second_, motions), motions, gradient);
    add_pulled_back(second_, compute_value(first_, motions), motions, gradient);
    return gradient;
}

PairMatrix LinkProduct::compute_second_derivative(const JointMotions& motions) const {
    PairMatrix derivative = PairMatrix::Zero();
    if (!first_.is_fixed() && !second_.is_fixed()) {
        const PairMatrix half =
            compute_jacobian(first_, motions).transpose() * compute_jacobian(second_, motions);
        derivative = half + half.transpose();
    }
    add_turned(first_, compute_value(second_, motions), motions, derivative);
    add_turned(second_, compute_value(first_, motions), motions, derivative);
    return derivative;
}

Jet<PairRow> LinkProduct::differentiate(const JointMotions& motions,
                                        const JointLinearizations& linearizations) const {
    const VectorJet first = compute_vector_jet(first_, motions);
    const VectorJet second = compute_vector_jet(second_, motions);
    return multiply<PairRow>(second, differentiate_vector(first_, motions, linearizations)) +
           multiply<PairRow>(first, differentiate_vector(second_, motions, linearizations));
}

}  // namespace gxrod
