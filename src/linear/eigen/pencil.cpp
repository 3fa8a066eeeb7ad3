#include "linear/eigen/pencil.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

// Of a node.
constexpr int six = 6;

// y += A x of six rows and columns that lie `stride` apart.
void add_tile(const double* entries, std::int64_t stride, const double* x, double* y) {
    double sums[six] = {};
    for (int column = 0; column < six; ++column) {
        for (int row = 0; row < six; ++row) sums[row] += entries[column * stride + row] * x[column];
    }
    for (int row = 0; row < six; ++row) y[row] += sums[row];
}

}  // namespace

void multiply(const SparsePattern& pattern,
              const std::vector<double>& values,
              const Eigen::Ref<const Eigen::VectorXd>& x,
              Eigen::VectorXd& y) {
    y.setZero(pattern.size());
    for (std::size_t index = 0; index < pattern.block_count(); ++index) {
        const SparsePattern::Block block = pattern.block(index);
        const double* entries = values.data() + block.first_entry;
        const double* factors = x.data() + block.first_column;
        for (const SparsePattern::RowRun& run : block.runs) {
            double* rows = y.data() + run.first;
            if (block.columns == six && run.count % six == 0) {
                for (std::int32_t i = 0; i < run.count; i += six)
                    add_tile(entries + i, block.stride, factors, rows + i);
            } else {
                for (std::int64_t column = 0; column < block.columns; ++column) {
                    for (std::int32_t i = 0; i < run.count; ++i)
                        rows[i] += factors[column] * entries[column * block.stride + i];
                }
            }
            entries += run.count;
        }
    }
}

std::vector<double> combine(const std::vector<double>& a, double factor, const std::vector<double>& b) {
    std::vector<double> sum = a;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * b[i];
    return sum;
}

std::vector<double> make_symmetric(const SparsePattern& pattern, const std::vector<double>& values) {
    std::vector<double> symmetric = values;
    pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        if (row != column) symmetric[slot] = 0.5 * (values[slot] + values[pattern.slot(column, row)]);
    });
    return symmetric;
}

double find_typical_ratio(const SparsePattern& pattern,
                          const std::vector<double>& K,
                          const std::vector<double>& M) {
    std::vector<double> ratios;
    bool has_inertia = false;
    for (std::int64_t i = 0; i < pattern.size(); ++i) {
        const auto slot = static_cast<std::size_t>(pattern.slot(i, i));
        has_inertia = has_inertia || M[slot] > 0.0;
        if (M[slot] > 0.0 && K[slot] != 0.0) ratios.push_back(std::abs(K[slot]) / M[slot]);
    }
    if (ratios.empty()) return has_inertia ? 1.0 : 0.0;
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    return *middle;
}

}  // namespace gxrod
