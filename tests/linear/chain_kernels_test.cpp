#include "linear/chains/chain_kernels.hpp"

#include <numeric>

#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

Eigen::MatrixXd make_random(int rows, int columns, unsigned seed) {
    RandomValues random(seed);
    Eigen::MatrixXd matrix(rows, columns);
    for (double& entry : matrix.reshaped()) entry = random.number(-1.0, 1.0);
    return matrix;
}

std::vector<ChainKernels> all_kernels() {
    std::vector<ChainKernels> kernels{find_chain_kernels(InstructionSet::baseline)};
    for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
        if (set <= find_instruction_set()) kernels.push_back(find_chain_kernels(set));
    }
    return kernels;
}

// One step in a dense matrix: its first block, and the others that are its neighbours.
class OneStep {
  public:
    OneStep(int size, const std::vector<int>& neighbours, unsigned seed)
        : total_(std::accumulate(neighbours.begin(), neighbours.end(), size)) {
        matrix = make_random(total_, total_, seed);
        matrix.diagonal().array() += 2.0 * total_;
        step_.size = size;
        step_.diagonal = copy(0, 0, size, size);
        int first = size;
        for (const int other : neighbours) {
            starts_.push_back(first);
            ChainCoupling coupling{};
            coupling.to = take(size * other);
            coupling.diagonal = copy(first, first, other, other);
            coupling.row = {first * total_, total_, true};
            coupling.column = {first, total_, true};
            coupling.first = first;
            coupling.size = other;
            coupling.apart = -1;
            couplings_.push_back(coupling);
            first += other;
        }
        if (neighbours.size() == 2) {
            step_.across = copy(starts_[0], starts_[1], neighbours[0], neighbours[1]);
            step_.back = copy(starts_[1], starts_[0], neighbours[1], neighbours[0]);
        }
        step_.couplings = static_cast<int>(neighbours.size());
        step_.copies = static_cast<int>(copies_.size());
    }

    ChainSteps chain() const {
        return {&step_, 1, couplings_.data(), static_cast<std::int64_t>(couplings_.size()), copies_.data()};
    }
    // Substitution adds to the neighbours apart from their unknowns.
    void add_apart() {
        for (ChainCoupling& coupling : couplings_) coupling.apart = coupling.first - step_.size;
    }
    std::vector<double> make_blocks() const { return std::vector<double>(blocks_, 0.0); }

    // What the neighbours' blocks have become.
    Eigen::MatrixXd remainder(const std::vector<double>& blocks) const {
        Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(total_ - step_.size, total_ - step_.size);
        for (const BlockCopy& copy : copies_) {
            if (copy.to == step_.diagonal) continue;
            const int row = static_cast<int>(copy.from) % total_ - step_.size;
            const int column = static_cast<int>(copy.from) / total_ - step_.size;
            rest.block(row, column, copy.rows, copy.columns) =
                Eigen::Map<const Eigen::MatrixXd>(&blocks[copy.to], copy.rows, copy.columns);
        }
        return rest;
    }

    Eigen::MatrixXd matrix;

  private:
    std::int64_t take(int count) {
        blocks_ += count;
        return blocks_ - count;
    }
    std::int64_t copy(int row, int column, int rows, int columns) {
        copies_.push_back({column * total_ + row, take(rows * columns), total_, rows, columns});
        return copies_.back().to;
    }

    int total_;
    std::vector<int> starts_;
    ChainStep step_{};
    std::vector<ChainCoupling> couplings_;
    std::vector<BlockCopy> copies_;
    std::int64_t blocks_ = 0;
};

// All combinations of sizes of a block and its neighbours.
template <class Visit>
void for_each_step(Visit&& visit) {
    for (const int size : {1, 3, 6, 7, 12, 15, 18, 24, 30}) {
        for (const std::vector<int>& neighbours :
             {std::vector<int>{}, {6}, {6, 6}, {3}, {6, 5}, {12, 6}, {18, 24}, {30, 6}}) {
            CAPTURE(size, neighbours);
            visit(OneStep(size, neighbours, 7), size);
        }
    }
}

}  // namespace

TEST_CASE("A block of any size is eliminated as by a dense LU, in the same bits by all sets", "[linear]") {
    for_each_step([](const OneStep& problem, int n) {
        const Eigen::MatrixXd& A = problem.matrix;
        const auto rest = Eigen::seq(n, Eigen::last);
        const auto own = Eigen::seq(0, n - 1);
        const Eigen::MatrixXd expected =
            A(rest, rest) - A(rest, own) * solve_dense(A(own, own), A(own, rest));
        std::vector<double> first;
        for (const ChainKernels& kernels : all_kernels()) {
            std::vector<double> blocks = problem.make_blocks();
            std::int64_t negative_pivots = 0;
            REQUIRE(kernels.eliminate(problem.chain(), A.data(), blocks.data(), negative_pivots));
            CHECK(relative_difference(problem.remainder(blocks), expected) < 1e-14);
            if (first.empty()) first = blocks;
            CHECK(blocks == first);
        }
    });
}

TEST_CASE("A step's solution is that of a dense LU, in the same bits by all sets", "[linear]") {
    for_each_step([](const OneStep& problem, int n) {
        const Eigen::MatrixXd& A = problem.matrix;
        const Eigen::VectorXd load = make_random(static_cast<int>(A.rows()), 1, 9);
        const Eigen::VectorXd expected = solve_dense(A, load);
        Eigen::VectorXd first;
        for (const ChainKernels& kernels : all_kernels()) {
            std::vector<double> blocks = problem.make_blocks();
            std::int64_t negative_pivots = 0;
            REQUIRE(kernels.eliminate(problem.chain(), A.data(), blocks.data(), negative_pivots));
            Eigen::VectorXd x = load;
            kernels.go_forward(problem.chain(), A.data(), blocks.data(), x.data(), nullptr);
            OneStep other = problem;
            other.add_apart();
            Eigen::VectorXd y = load;
            Eigen::VectorXd apart = Eigen::VectorXd::Zero(A.rows() - n);
            kernels.go_forward(other.chain(), A.data(), blocks.data(), y.data(), apart.data());
            CHECK(y.head(n) == x.head(n));
            CHECK(y.tail(A.rows() - n) == load.tail(A.rows() - n));
            CHECK((y.tail(A.rows() - n) + apart - x.tail(A.rows() - n)).norm() <= 1e-14 * x.norm());
            const Eigen::MatrixXd remainder = problem.remainder(blocks);
            if (remainder.size() > 0) x.tail(A.rows() - n) = solve_dense(remainder, x.tail(A.rows() - n));
            kernels.go_backward(problem.chain(), blocks.data(), x.data());
            CHECK(relative_difference(x, expected) < 1e-14);
            if (first.size() == 0) first = x;
            CHECK(x == first);
        }
    });
}

TEST_CASE("A pivot that vanishes is reported wherever it is", "[linear]") {
    for (const int size : {3, 6, 12, 18, 24, 30}) {
        for (int k = 0; k < size; ++k) {
            CAPTURE(size, k);
            OneStep problem(size, {6}, 7);
            problem.matrix.row(k).setZero();
            problem.matrix.col(k).setZero();
            for (const ChainKernels& kernels : all_kernels()) {
                std::vector<double> blocks = problem.make_blocks();
                std::int64_t negative_pivots = 0;
                CHECK_FALSE(kernels.eliminate(
                    problem.chain(), problem.matrix.data(), blocks.data(), negative_pivots));
            }
        }
    }
}

TEST_CASE("Runs of entries are subtracted, and their magnitudes summed", "[linear]") {
    for (const int rows : {1, 2, 3, 5, 6, 12, 18, 23, 36}) {
        for (const int columns : {1, 3, 6, 18}) {
            CAPTURE(rows, columns);
            constexpr int row = 2;
            constexpr int column = 1;
            const Eigen::MatrixXd A = make_random(rows + 4, columns, 3);
            const Eigen::VectorXd x = make_random(column + columns, 1, 4);
            const Eigen::VectorXd start = make_random(row + rows + 1, 1, 5);
            const EntryRun run{3, rows + 4, row, column, rows, columns};
            const Eigen::MatrixXd entries = A.middleRows(3, rows);
            Eigen::VectorXd y_expected = start;
            Eigen::VectorXd sums_expected = start.cwiseAbs();
            y_expected.segment(row, rows) -= entries * x.tail(columns);
            sums_expected.segment(row, rows) += entries.cwiseAbs() * x.tail(columns).cwiseAbs();
            Eigen::VectorXd first;
            for (const ChainKernels& kernels : all_kernels()) {
                Eigen::VectorXd y = start;
                Eigen::VectorXd sums = start.cwiseAbs();
                kernels.subtract(&run, 1, A.data(), x.data(), y.data(), sums.data());
                CHECK(relative_difference(y, y_expected) < 1e-15);
                CHECK(relative_difference(sums, sums_expected) < 1e-15);
                if (first.size() == 0) first = y;
                CHECK(y == first);
            }
        }
    }
}
