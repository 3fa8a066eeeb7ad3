#include "linear/transposed_values.hpp"

namespace gxrod {

std::vector<double> transpose_values(const SparsePattern& pattern, const std::vector<double>& values) {
    std::vector<double> transposed(values.size());
    pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        transposed[static_cast<std::size_t>(pattern.slot(column, row))] =
            values[static_cast<std::size_t>(slot)];
    });
    return transposed;
}

}  // namespace gxrod
