#include "linear/eigen/pencil.hpp"

namespace gxrod {

void multiply(const SparsePattern& pattern,
              const std::vector<double>& values,
              const Eigen::VectorXd& x,
              Eigen::VectorXd& y) {
    y.setZero(pattern.size());
    for (std::size_t index = 0; index < pattern.block_count(); ++index) {
        const SparsePattern::Block block = pattern.block(index);
        for (std::int64_t column = 0; column < block.columns; ++column) {
            const double factor = x[block.first_column + column];
            const double* entries = values.data() + block.first_entry + column * block.stride;
            for (const SparsePattern::RowRun& run : block.runs) {
                double* rows = y.data() + run.first;
                for (std::int32_t i = 0; i < run.count; ++i) rows[i] += factor * entries[i];
                entries += run.count;
            }
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

}  // namespace gxrod
