#pragma once

#include "integrators/integrator.hpp"
#include "rotation/types.hpp"
#include "state/state.hpp"

// The Newmark update that the rotational variants share (Rubin 2007, section 4).
namespace gxrod {

struct Newmark {
    Newmark(double beta_, double gamma_) : beta(beta_), gamma(gamma_) {}

    double beta;
    double gamma;

    // Computes the acceleration at the end of a step from its mean velocity w = increment/Δt, (4.7a).
    Vec3 acceleration(const Vec3& w,
                      const Vec3& velocity_n,
                      const Vec3& acceleration_n,
                      double time_step) const {
        return (w - velocity_n) / (beta * time_step) - ((1.0 - 2.0 * beta) / (2.0 * beta)) * acceleration_n;
    }
    // Computes the velocity at the end of a step from both accelerations, (4.7b).
    Vec3 velocity(const Vec3& velocity_n,
                  const Vec3& acceleration_n,
                  const Vec3& acceleration,
                  double time_step) const {
        return velocity_n + time_step * ((1.0 - gamma) * acceleration_n + gamma * acceleration);
    }
    // How a scalar that changes by these with velocity and acceleration at the end of a step changes with
    // the increment and with what was before.
    struct Transposed {
        Vec3 increment, velocity_n, acceleration_n;
    };
    Transposed transpose(const Vec3& by_velocity, const Vec3& by_acceleration, double time_step) const {
        const Vec3 all = by_acceleration + gamma * time_step * by_velocity;
        return {all / (beta * time_step * time_step),
                by_velocity - all / (beta * time_step),
                (1.0 - gamma) * time_step * by_velocity - ((1.0 - 2.0 * beta) / (2.0 * beta)) * all};
    }
    // The derivatives of velocity and acceleration by the increment.
    double rate(double time_step) const { return gamma / (beta * time_step); }
    double acceleration_rate(double time_step) const { return 1.0 / (beta * time_step * time_step); }

    // Returns Integrator::contact_weight: positions change by β Δt² for an acceleration and by Δt²/2 for an
    // impulse.
    double contact_weight() const { return 1.0 / (2.0 * beta); }
    // Implements Integrator::split_impulses. With β = γ/2 velocities contain the whole impulses.
    void split_impulses(const State& state, std::vector<Vec6>& shocked) const;
};

// Computes v and a of a node from its displacement over the step.
void update_translation(const Newmark& newmark,
                        const NodeMotion& previous,
                        double time_step,
                        NodeMotion& trial);

// Transposes update_translation of a node, as Integrator::transpose_rates.
void transpose_translation(const Newmark& newmark,
                           double time_step,
                           const MotionGradient::OfNode& rates,
                           MotionGradient::OfNode& trial,
                           MotionGradient::OfNode& previous);
// Adds how a scalar changes with the spins at both ends of a step that changes by this with its rotation
// vector θ: δθ = T(θ)⁻¹ δφ − T(θ)⁻ᵀ δφ_n.
void transpose_turn(const Vec3& theta,
                    const Vec3& by_theta,
                    MotionGradient::OfNode& trial,
                    MotionGradient::OfNode& previous);

// Factors of the local error of a step, docs/theory/newmark.md, (E1): for placements from the change of
// accelerations over the step, for spins also from ω × α, for rates from the change of accelerations if the
// scheme has order 1.
struct NewmarkError {
    double placement;  // β − 1/6, times the change of accelerations
    double twist;      // times Δt ω × α
    double rate;       // times the change of accelerations and Δt
};
StepError estimate_newmark_error(const NewmarkError& factors,
                                 const State& state,
                                 double time_step,
                                 const NodeLengths& lengths,
                                 bool is_algorithmic = false);

// Extrapolates nodes from the velocity and acceleration of the last step over the time h: r + h v + ½h² a and
// θ = h ω + ½h² α.
void predict_constant_acceleration(State& state, double h, NodeRange nodes);

}  // namespace gxrod
