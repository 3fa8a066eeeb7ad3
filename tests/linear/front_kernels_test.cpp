#include "linear/fronts/front_kernels.hpp"

#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

std::vector<FrontKernels> kernels_of_sets() {
    std::vector<FrontKernels> kernels;
    for (const InstructionSet set :
         {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
        if (set <= find_instruction_set()) kernels.push_back(find_front_kernels(set));
    }
    return kernels;
}

// A dense matrix in two fronts: the second has what follows the pivots of the first.
class TwoFronts {
  public:
    TwoFronts(int pivots, int behind) : matrix(pivots + behind, pivots + behind) {
        RandomValues random(3);
        for (double& entry : matrix.reshaped()) entry = random.number(-1.0, 1.0);
        matrix.diagonal().array() += 2.0 * (pivots + behind);
        const int total = pivots + behind;
        const int size = pivots * total;
        const int rest = pivots * behind;
        fronts_[0] = {.lower = 0,
                      .upper = size,
                      .update = 0,
                      .runs = 0,
                      .copies = 0,
                      .children = 0,
                      .first = 0,
                      .pivots = pivots,
                      .rows = total,
                      .run_count = 1,
                      .copy_count = 2,
                      .child_count = 0,
                      .stack = 1};
        fronts_[1] = {.lower = size + rest,
                      .upper = 0,
                      .update = 0,
                      .runs = 1,
                      .copies = 2,
                      .children = 0,
                      .first = pivots,
                      .pivots = behind,
                      .rows = behind,
                      .run_count = 0,
                      .copy_count = 1,
                      .child_count = 1,
                      .stack = 0};
        run_ = {pivots, 0, behind};
        copies_[0] = {0, 0, total, total, total, pivots};
        copies_[1] = {size, size, total, pivots, pivots, behind};
        copies_[2] = {size + pivots, size + rest, total, behind, behind, behind};
        factors_.resize(size + rest + behind * behind);
        update_.resize(behind * behind);
    }

    bool eliminate(const FrontKernels& kernels) {
        double* const stacks[2] = {nullptr, update_.data()};
        negative_pivots = 0;
        // Whatever was there before.
        std::fill(factors_.begin(), factors_.end(), 7.0);
        std::fill(update_.begin(), update_.end(), 7.0);
        return kernels.eliminate(all(), 0, matrix.data(), factors_.data(), stacks, negative_pivots) &&
               kernels.eliminate(all(), 1, matrix.data(), factors_.data(), stacks, negative_pivots);
    }
    Eigen::VectorXd solve(const FrontKernels& kernels, Eigen::VectorXd x) {
        std::vector<double> work(fronts_[1].rows);
        for (const int front : {0, 1})
            kernels.go_forward(all(), front, factors_.data(), x.data(), work.data());
        for (const int front : {1, 0})
            kernels.go_backward(all(), front, factors_.data(), x.data(), work.data());
        return x;
    }
    // Of the first front.
    Eigen::MatrixXd update() const {
        return Eigen::Map<const Eigen::MatrixXd>(update_.data(), fronts_[1].rows, fronts_[1].rows);
    }

    std::int64_t negative_pivots = 0;  // of the last elimination
    Eigen::MatrixXd matrix;

  private:
    Fronts all() const { return {fronts_, 2, &run_, copies_, &child_}; }

    Front fronts_[2];
    FrontRun run_;
    FrontCopy copies_[3];
    std::int32_t child_ = 0;
    std::vector<double> factors_, update_;
};

}  // namespace

TEST_CASE("Fronts of any size are eliminated as by a dense LU, in the same bits by all sets", "[linear]") {
    for (const int pivots : {1, 3, 6, 7, 12, 17, 48, 101, 210}) {
        for (const int behind : {1, 2, 5, 6, 13, 36, 100, 205}) {
            CAPTURE(pivots, behind);
            TwoFronts problem(pivots, behind);
            const Eigen::MatrixXd& A = problem.matrix;
            const auto own = Eigen::seq(0, pivots - 1);
            const auto rest = Eigen::seq(pivots, Eigen::last);
            const Eigen::MatrixXd expected = -A(rest, own) * solve_dense(A(own, own), A(own, rest));
            const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(A.rows(), 1.0, 2.0);
            const Eigen::VectorXd solution = solve_dense(A, load);
            Eigen::VectorXd first;
            for (const FrontKernels& kernels : kernels_of_sets()) {
                REQUIRE(problem.eliminate(kernels));
                CHECK(relative_difference(problem.update(), expected) < 1e-13);
                const Eigen::VectorXd x = problem.solve(kernels, load);
                CHECK(relative_difference(x, solution) < 1e-13);
                if (first.size() == 0) first = x;
                CHECK(x == first);
            }
        }
    }
}

TEST_CASE("A pivot of a front that vanishes is reported wherever it is", "[linear]") {
    for (const int pivots : {3, 6, 20}) {
        for (int k = 0; k < pivots + 6; ++k) {
            CAPTURE(pivots, k);
            TwoFronts problem(pivots, 6);
            problem.matrix.row(k).setZero();
            problem.matrix.col(k).setZero();
            for (const FrontKernels& kernels : kernels_of_sets()) CHECK_FALSE(problem.eliminate(kernels));
        }
    }
}
