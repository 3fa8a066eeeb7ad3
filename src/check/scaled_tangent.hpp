#pragma once

#include "assembly/system.hpp"

namespace gxrod {

// A tangent K in comparable unknowns: δr over the model's length, and so the forces times it; divided by the
// length of its longest column. The system must outlive it.
class ScaledTangent {
  public:
    // Takes values on the system's pattern, or on one that has more entries; it must outlive this.
    ScaledTangent(const System& system, const SparsePattern& pattern, const std::vector<double>& values);

    const SparsePattern& pattern() const { return *pattern_; }
    const std::vector<double>& values() const { return values_; }
    bool is_finite() const { return is_finite_; }

    Eigen::VectorXd multiply(const Eigen::VectorXd& x) const;
    // Computes the values of Kᵀ, on the same pattern, which is symmetric.
    std::vector<double> compute_transpose() const;

  private:
    const SparsePattern* pattern_;
    std::vector<double> values_;
    bool is_finite_ = true;
};

}  // namespace gxrod
