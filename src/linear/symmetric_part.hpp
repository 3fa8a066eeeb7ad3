#pragma once

#include "linear/sparse_pattern.hpp"

namespace gxrod {

// The lower triangle of ½(A + Aᵀ), diagonal included, of a matrix A on a pattern.
class SymmetricPart {
  public:
    explicit SymmetricPart(const SparsePattern& pattern);

    // Of the lower triangle; every diagonal entry is in it.
    const CompressedColumns& pattern() const { return lower_; }
    // Values on pattern() from values on the pattern of A.
    void compute(const std::vector<double>& values, std::vector<double>& lower) const;

  private:
    CompressedColumns lower_;
    // Of each entry (i, j) of the lower triangle: the slots of a_ij and a_ji, −1 where there is none.
    std::vector<std::int64_t> slots_, mirrored_;
};

}  // namespace gxrod
