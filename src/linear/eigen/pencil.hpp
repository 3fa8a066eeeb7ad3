#pragma once

#include <Eigen/Core>
#include <vector>

#include "linear/linear_solver.hpp"
#include "linear/sparse_pattern.hpp"

namespace gxrod {

// Computes y = A x for a matrix given by its values on a pattern.
void multiply(const SparsePattern& pattern,
              const std::vector<double>& values,
              const Eigen::Ref<const Eigen::VectorXd>& x,
              Eigen::VectorXd& y);
inline Eigen::VectorXd multiply(const SparsePattern& pattern,
                                const std::vector<double>& values,
                                const Eigen::Ref<const Eigen::VectorXd>& x) {
    Eigen::VectorXd y;
    multiply(pattern, values, x, y);
    return y;
}

// Computes a + factor b, value by value.
std::vector<double> combine(const std::vector<double>& a, double factor, const std::vector<double>& b);

// Computes (A + Aᵀ)/2.
std::vector<double> make_symmetric(const SparsePattern& pattern, const std::vector<double>& values);

// Returns a typical K_ii / M_ii; 1 if nothing is stiff, 0 if nothing has inertia.
double find_typical_ratio(const SparsePattern& pattern,
                          const std::vector<double>& K,
                          const std::vector<double>& M);

// A pair of symmetric matrices, A x = θ B x with B positive definite and factorized. B⁻¹A is self-adjoint in
// the inner product of B, and of A if A has no negative eigenvalue.
class Pencil {
  public:
    enum class InnerProduct { of_a, of_b };

    // All must outlive this; the solver has B's factors.
    Pencil(const SparsePattern& pattern,
           const std::vector<double>& A,
           const std::vector<double>& B,
           LinearSolver& inverse_of_B,
           InnerProduct inner)
        : pattern_(&pattern), a_(&A), b_(&B), inverse_(&inverse_of_B), inner_(inner) {}

    std::int64_t size() const { return pattern_->size(); }
    // Computes the vector whose scalar product with x is the inner product of v and x.
    void compute_image(const Eigen::Ref<const Eigen::VectorXd>& v, Eigen::VectorXd& image) const {
        multiply(*pattern_, inner_ == InnerProduct::of_a ? *a_ : *b_, v, image);
    }
    // Computes w = B⁻¹A v, from v and its image.
    void apply(const Eigen::Ref<const Eigen::VectorXd>& v,
               const Eigen::Ref<const Eigen::VectorXd>& image,
               Eigen::VectorXd& w) const {
        if (inner_ == InnerProduct::of_a) {
            w = image;
        } else {
            multiply(*pattern_, *a_, v, w);
        }
        inverse_->solve(w);
    }

  private:
    const SparsePattern* pattern_;
    const std::vector<double>* a_;
    const std::vector<double>* b_;
    LinearSolver* inverse_;
    InnerProduct inner_;
};

}  // namespace gxrod
