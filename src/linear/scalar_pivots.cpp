#include "linear/scalar_pivots.hpp"

#include <Eigen/SparseCholesky>

namespace gxrod {

std::int64_t count_negative_pivots(const SparsePattern& pattern, const std::vector<double>& values) {
    using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
    std::vector<Eigen::Triplet<double, std::int64_t>> entries;
    pattern.visit_entries([&](std::int64_t i, std::int64_t j, std::int64_t slot) {
        if (i >= j) entries.emplace_back(i, j, values[static_cast<std::size_t>(slot)]);
    });
    Matrix lower(pattern.size(), pattern.size());
    lower.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<std::int64_t>> factors(lower);
    if (factors.info() != Eigen::Success || !factors.vectorD().allFinite()) return -1;
    return (factors.vectorD().array() < 0.0).count();
}

}  // namespace gxrod
