#include "state/increment.hpp"

#include <numbers>

#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

namespace {

// A product of unit quaternions of length 1 again: what rounding adds is too small for its square to count.
Quat renormalize(const Quat& q) { return Quat((1.5 - 0.5 * q.squaredNorm()) * q.coeffs()); }

// In statics a node can turn by any angle within one step. T(θ)⁻¹ is singular at whole turns, where exp(θ)
// says nothing of the axis of θ either: there θ is the sum of its spins, elsewhere the nearest to that.
void turn_beyond_half(const NodeMotion& previous, const Vec3& delta_phi, NodeMotion& trial) {
    constexpr double close = 0.1;  // rad, to a whole turn
    trial.Lambda = renormalize(exp_quaternion(delta_phi) * trial.Lambda);
    trial.theta += delta_phi;
    const Quat step = trial.Lambda * previous.Lambda.conjugate();
    if (log(step).norm() > close) trial.theta = log_nearest(step, trial.theta);
}

// The vector of `step` that is nearest to θ + T(θ)⁻¹ δφ. Of small rotations it is the shortest.
Vec3 find_rotation(const Quat& step, const Vec3& theta, const Vec3& delta_phi) {
    constexpr double small = 0.5;  // rad²: both together turn by less than 1 rad
    if (theta.squaredNorm() + delta_phi.squaredNorm() < small) return log(step);
    return log_nearest(step, theta + tangent_map_inverse(theta) * delta_phi);
}

}  // namespace

void apply_spin(const NodeMotion& previous, const Vec3& delta_r, const Vec3& delta_phi, NodeMotion& trial) {
    trial.r += delta_r;
    if (trial.theta.squaredNorm() >= std::numbers::pi * std::numbers::pi) {
        turn_beyond_half(previous, delta_phi, trial);
        return;
    }
    // Composed from θ rather than from Λ Λₙᵀ, a small rotation keeps its relative accuracy; rates divide it
    // by Δt².
    const Quat step = renormalize(exp_quaternion(delta_phi) * exp_quaternion(trial.theta));
    trial.theta = find_rotation(step, trial.theta, delta_phi);
    trial.Lambda = renormalize(step * previous.Lambda);
}

void place(const NodeMotion& previous, const Vec3& r, const Vec3& theta, NodeMotion& trial) {
    trial.r = r;
    trial.theta = theta;
    trial.Lambda = renormalize(exp_quaternion(theta) * previous.Lambda);
}

}  // namespace gxrod
