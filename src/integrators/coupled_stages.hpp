#pragma once

#include <Eigen/Core>
#include <complex>

#include "integrators/integrator.hpp"

namespace gxrod {

// A Runge-Kutta scheme whose stages depend on each other and are solved together, in the rotation vectors of
// the step: with A the matrix of the scheme, c its fractions, for node i at stage j
//   r_j = r_n + Δt Σ_k a_jk v_k,   v_j = v_n + Δt Σ_k a_jk a_k,
//   θ_j = Δt Σ_k a_jk T(θ_k)⁻¹ ω_k,   ω_j = ω_n + Δt Σ_k a_jk α_k
// (docs/theory/newmark.md, (R1)). The stages' placements are the unknowns; rates follow by A⁻¹.
// State::stage_motions has them. A⁻¹ = V diag(λ) V⁻¹ splits the linear equations of all stages into one
// system for each λ (Hairer & Wanner 1996, IV.8): one real, if the number of stages is odd, and one complex;
// no scheme here has more than three stages.
class CoupledStages : public Integrator {
  public:
    using Matrix = Eigen::MatrixXd;
    using Vector = Eigen::VectorXd;

    // Makes Radau IIA with three stages: order 5, stage order 3, L-stable; the last stage is the end of the
    // step. Its error is estimated as by Hairer & Wanner (IV.8.20).
    static CoupledStages make_radau_5();
    // Makes Gauss with two stages: order 4, stage order 2, symmetric, without numerical damping. The end of
    // the step is not a stage.
    static CoupledStages make_gauss_4();

    const CoupledStages* coupled() const override { return this; }
    double contact_weight() const override { return 1.0; }
    bool resolves_contact() const override { return true; }
    int stage_count() const override { return static_cast<int>(fractions_.size()); }
    double stage_fraction(int stage) const override { return fractions_[stage]; }
    bool ends_with_stage() const { return ends_with_stage_; }
    int error_order() const override { return error_order_; }
    std::vector<double> power_weights() const override;
    int carried_count() const override { return stage_count() - 1; }
    void start(State& state) const override;

    // The matrix A⁻¹.
    const Matrix& inverse() const { return inverse_; }
    // The λ of the real equation, 0 without one, and of the complex equation; both over Δt.
    double real_factor() const { return real_factor_; }
    std::complex<double> complex_factor() const { return complex_factor_; }
    // A λ for a tangent that needs only one.
    double typical_factor() const { return real_factor_ > 0.0 ? real_factor_ : std::abs(complex_factor_); }
    // Rows of V⁻¹: they give an unknown of the equations from the unknowns of the stages.
    const Vector& to_real() const { return to_real_; }
    const Eigen::VectorXcd& to_complex() const { return to_complex_; }
    // Columns of V: an unknown of a stage is the real unknown times from_real plus twice the real part of the
    // complex unknown times from_complex.
    const Vector& from_real() const { return from_real_; }
    const Eigen::VectorXcd& from_complex() const { return from_complex_; }

    // Computes the derivatives of the rates of stage `j` by the placements of stage `k`, for the state's
    // stages.
    void linearize(const State& state,
                   double time_step,
                   int j,
                   int k,
                   std::vector<NodeLinearization>& linearizations,
                   const ThreadTeam& team) const;
    using Integrator::linearize;

    // Predicts the placements in State::stage_motions, from velocities and accelerations at the start, or by
    // extrapolating the accelerations of the last step's stages.
    enum class Prediction { from_start, from_last_step };
    void predict(State& state, const Stage& step, Prediction prediction, const ThreadTeam& team) const;
    // Computes velocities and accelerations of all stages from their placements.
    void update_stages(State& state, const Stage& step, const ThreadTeam& team) const;
    // Sets the trial to the end of the step, including its accelerations if that is a stage.
    void end_step(State& state, const Stage& step, const ThreadTeam& team) const;

    // Interpolates all values by polynomials through the start, the stages and the end
    // (docs/theory/newmark.md, (D2)).
    void interpolate(const State& state,
                     double time_step,
                     double fraction,
                     std::vector<NodeMotion>& motions,
                     const ThreadTeam& team = ThreadTeam::alone()) const override;
    Interpolant interpolant() const override;
    std::vector<double> inner_fractions() const override;

    // The right-hand side from which the real equation's solution estimates the error, per unit of Δt: for a
    // node, additions to v and a at the start, from the placements and rates of the stages.
    struct Defect {
        Vec6 rates = Vec6::Zero();          // v, θ′
        Vec6 accelerations = Vec6::Zero();  // a, α
    };
    Defect compute_defect(const State& state, double time_step, std::size_t node) const;

  protected:
    // These treat the end of a step, with the typical factor, for callers outside of a step.
    void place_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void update_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void linearize_nodes(const State& state,
                         const Stage& stage,
                         NodeRange nodes,
                         std::vector<NodeLinearization>& linearizations) const override;

  private:
    CoupledStages(const Matrix& a, Vector fractions, bool ends_with_stage);

    void carry(State& state, double time_step, std::size_t node) const;

    Matrix inverse_;  // A⁻¹
    Matrix carried_;  // rows: coefficients of (s − 1)ᵐ, m ≥ 1, of the polynomial through values at the stages
    Vector weights_;  // weights b of the end
    Vector end_;      // A⁻ᵀ b
    Vector fractions_;
    bool ends_with_stage_;
    int error_order_ = 0;
    Vector error_weights_;
    double real_factor_ = 0.0;
    std::complex<double> complex_factor_;
    Vector to_real_, from_real_;
    Eigen::VectorXcd to_complex_, from_complex_;
};

}  // namespace gxrod
