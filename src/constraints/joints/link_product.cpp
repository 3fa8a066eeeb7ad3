#include "constraints/joints/link_product.hpp"

#include "constraints/joints/pull_back.hpp"

namespace gxrod {

namespace {

using Kind = LinkVector::Kind;

VectorJet compute_vector(const LinkVector& u, const JointFrames& frames) {
    switch (u.kind) {
        case Kind::on_a:
            return frames.carry_on_a(u.vector);
        case Kind::on_b:
            return frames.carry_on_b(u.vector);
        case Kind::separation:
            return frames.separation;
        default:
            return {u.vector, Vec3::Zero(), Vec3::Zero()};
    }
}

Vec3 compute_value(const LinkVector& u, const JointFrames& frames) {
    switch (u.kind) {
        case Kind::on_a:
            return frames.R_a * u.vector;
        case Kind::on_b:
            return frames.R_b * u.vector;
        case Kind::separation:
            return frames.separation.value;
        default:
            return u.vector;
    }
}

// Adds gᵀ ∂u/∂(δr, δφ), (J5).
void add_pulled_back(Kind kind, const Vec3& u, const Vec3& g, const JointFrames& frames, PairRow& row) {
    if (kind == Kind::on_a) row.segment<3>(3) += u.cross(g);
    if (kind == Kind::on_b) row.segment<3>(9) += u.cross(g);
    if (kind != Kind::separation) return;
    row.segment<3>(0) -= g;
    row.segment<3>(3) -= frames.arm_a.value.cross(g);
    row.segment<3>(6) += g;
    row.segment<3>(9) += frames.arm_b.value.cross(g);
}

void add_pulled_back(Kind kind,
                     const VectorJet& u,
                     const VectorJet& g,
                     const JointFrames& frames,
                     const JointLinearizations& linearizations,
                     PairRow& row) {
    const auto& [a, b] = frames.motions;
    if (kind == Kind::on_a) row.segment<3>(3) += pull_back_carried(u, g, a, linearizations.a);
    if (kind == Kind::on_b) row.segment<3>(9) += pull_back_carried(u, g, b, linearizations.b);
    if (kind != Kind::separation) return;
    row.segment<3>(0) -= pull_back_moved(g, linearizations.a);
    row.segment<3>(3) -= pull_back_carried(frames.arm_a, g, a, linearizations.a);
    row.segment<3>(6) += pull_back_moved(g, linearizations.b);
    row.segment<3>(9) += pull_back_carried(frames.arm_b, g, b, linearizations.b);
}

// By which the changes of u, u̇ and ü are multiplied in those of the weighted values of u · w, (J3).
VectorJet weigh(const VectorJet& w, const ScalarJet& weights) {
    return {weights.value * w.value + weights.rate * w.rate + weights.acceleration * w.acceleration,
            weights.rate * w.value + 2.0 * weights.acceleration * w.rate,
            weights.acceleration * w.value};
}

}  // namespace

ScalarJet LinkProduct::compute_jet(const JointFrames& frames) const {
    const VectorJet u = compute_vector(u_, frames), w = compute_vector(w_, frames);
    ScalarJet jet{};
    jet.value = u.value.dot(w.value);
    if (frames.level == ConstraintLevel::position) return jet;
    jet.rate = u.rate.dot(w.value) + u.value.dot(w.rate);
    if (frames.level == ConstraintLevel::velocity) return jet;
    jet.acceleration = u.acceleration.dot(w.value) + 2.0 * u.rate.dot(w.rate) + u.value.dot(w.acceleration);
    return jet;
}

void LinkProduct::add_gradient(const JointFrames& frames, double factor, PairRow& row) const {
    const Vec3 u = compute_value(u_, frames), w = compute_value(w_, frames);
    add_pulled_back(u_.kind, u, factor * w, frames, row);
    add_pulled_back(w_.kind, w, factor * u, frames, row);
}

void LinkProduct::add_change(const JointFrames& frames,
                             const JointLinearizations& linearizations,
                             const ScalarJet& weights,
                             PairRow& row) const {
    const VectorJet u = compute_vector(u_, frames), w = compute_vector(w_, frames);
    add_pulled_back(u_.kind, u, weigh(w, weights), frames, linearizations, row);
    add_pulled_back(w_.kind, w, weigh(u, weights), frames, linearizations, row);
}

void LinkProduct::add_reaction(const JointFrames& frames, double multiplier, JointReaction& reaction) const {
    const Vec3 u = multiplier * compute_value(u_, frames);
    if (w_.kind == Kind::on_b) {
        reaction.moments += u * compute_value(w_, frames).transpose();
        return;
    }
    reaction.force += u;
    if (u_.kind == Kind::on_a) reaction.carried += u;
    if (u_.kind != Kind::separation) return;
    reaction.force += u;
    reaction.pull += 2.0 * multiplier;
}

}  // namespace gxrod
