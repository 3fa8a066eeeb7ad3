#pragma once

#include <Eigen/Core>
#include <complex>

#include "linear/eigen/quadratic_problem.hpp"
#include "linear/linear_solver.hpp"
#include "parallel/thread_team.hpp"

namespace gxrod {

// Arnoldi's method from several start vectors at once for the quadratic problem about a real shift σ: with μ
// = λ − σ and S = K + σ D + σ² M the operator
//
//   (x, y) → (−S⁻¹ ((D + 2 σ M) x + M y), x)
//
// has the eigenvalues θ = 1/μ and the vectors (x, μ x). Relaxing stiffness adds unknowns w = x/(1 + λτ), the
// strains of its dashpots (V22). Each new vector is made orthogonal to all others; the basis grows
// (docs/theory/vibrations.md, (V13)).
class BandArnoldi {
  public:
    // `inverse` has the factors of S. `weights` scale components; y is stored over `scale`, a typical |μ|.
    BandArnoldi(const QuadraticProblem& problem,
                double shift,
                LinearSolver& inverse,
                const Eigen::VectorXd& weights,
                double scale);

    // Adds a start vector, or later a vector with parts that the others lack. Returns false if the basis is
    // complete.
    bool add_noise();
    // Applies the operator to `steps` vectors of the basis; returns false if it yields nothing new.
    bool grow(int steps);

    Eigen::Index steps() const { return done_; }

    struct Ritz {
        Eigen::VectorXcd values;    // θ with Im θ ≤ 0 (Im λ ≥ 0), by falling |θ|
        Eigen::VectorXd residuals;  // relative to |θ|
        Eigen::MatrixXcd combinations;
    };
    Ritz find_ritz() const;
    // The x of a Ritz vector, improved by one more application, which removes parts without eigenvalue, with
    // μ = 1/θ and the relative residual: S⁻¹ times the problem, in the weighted norm.
    struct Vector {
        std::complex<double> mu;
        Eigen::VectorXcd x;
        double residual;
    };
    Vector make_vector(const Ritz& ritz, Eigen::Index index);

  private:
    using Index = Eigen::Index;
    using Ref = Eigen::Ref<const Eigen::VectorXd>;

    // Computes z → operator z; both weighted and scaled.
    void apply(const Ref& z, Eigen::VectorXd& image);
    // Computes −S⁻¹ ((D + 2 σ M) x + M y + Σ τ/(1 + στ) R w), unscaled; w one after the other.
    void apply_top(const Eigen::VectorXd& x,
                   const Eigen::VectorXd& y,
                   const Eigen::VectorXd& w,
                   Eigen::VectorXd& top);
    // The number of unknowns of the operator: x, y and each w.
    Index unknowns() const { return (2 + relaxing_count()) * problem_.size(); }
    Index relaxing_count() const { return static_cast<Index>(problem_.relaxing.size()); }
    // The factor of w that makes it about as large as x.
    double dashpot_scale(Index i) const;
    // Appends the part of w orthogonal to the basis; its components go into column j of H, if j ≥ 0.
    bool append(Index j);
    void reserve(Index columns);

    const QuadraticProblem& problem_;
    LinearSolver& inverse_;
    std::vector<double> damping_;  // D + 2 σ M
    double shift_;
    Eigen::VectorXd weights_;
    double scale_;
    Eigen::MatrixXd V_, H_;
    Index done_ = 0, end_ = 0;
    double largest_norm_ = 0.0;
    std::uint64_t seed_ = 31;
    Eigen::VectorXd image_, x_, y_, w_, top_, product_;
};

}  // namespace gxrod
