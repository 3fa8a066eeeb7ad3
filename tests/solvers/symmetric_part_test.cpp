#include "solvers/symmetric_part.hpp"

#include <catch2/catch.hpp>

#include "assembly/sample_model.hpp"
#include "solvers/sparse_samples.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("the symmetric part is the half of the matrix and its transpose", "[solvers]") {
    const Eigen::MatrixXd dense = make_unsymmetric_matrix(25, 8);
    const Sparse sparse = make_sparse(dense);
    const SymmetricPart part(sparse.pattern);
    std::vector<double> lower;
    part.compute(sparse.values, lower);
    const Eigen::MatrixXd expected = 0.5 * (dense + dense.transpose());
    CHECK(make_dense(part.pattern(), lower) == Eigen::MatrixXd(expected.triangularView<Eigen::Lower>()));
    for (std::int64_t i = 0; i < part.pattern().size(); ++i) {
        CHECK(part.pattern().rows[part.pattern().column_starts[i]] == i);
    }
}
