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
