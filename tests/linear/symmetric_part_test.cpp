#include "linear/symmetric_part.hpp"

#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("the symmetric part is the half of the matrix and its transpose", "[linear]") {
    const Eigen::MatrixXd dense = make_unsymmetric_matrix(25, 8);
    const Sparse sparse = make_sparse(dense);
    const SymmetricPart part(sparse.pattern);
    std::vector<double> lower;
    part.compute(sparse.values, lower);
    const Eigen::MatrixXd expected = 0.5 * (dense + dense.transpose());
    const auto& [starts, rows] = part.pattern();
    Eigen::MatrixXd found = Eigen::MatrixXd::Zero(expected.rows(), expected.cols());
    for (std::int64_t j = 0; j < part.pattern().size(); ++j) {
        CHECK(rows[starts[j]] == j);
        for (std::int64_t k = starts[j]; k < starts[j + 1]; ++k) found(rows[k], j) = lower[k];
    }
    CHECK(found == Eigen::MatrixXd(expected.triangularView<Eigen::Lower>()));
}
