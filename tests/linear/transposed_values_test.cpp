#include "linear/transposed_values.hpp"

#include <array>

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("values of a transposed matrix stand where its entries do", "[linear]") {
    // Entries (0,0), (0,1), (1,0), (1,1), (1,2), (2,1), (2,2).
    SparsePattern pattern;
    pattern.add_columns(1, std::array<std::int64_t, 2>{0, 1});
    pattern.add_columns(1, std::array<std::int64_t, 3>{0, 1, 2});
    pattern.add_columns(1, std::array<std::int64_t, 2>{1, 2});
    std::vector<double> values(7);
    pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        values[static_cast<std::size_t>(slot)] = static_cast<double>(10 * row + column);
    });
    const std::vector<double> transposed = transpose_values(pattern, values);
    int entries = 0;
    pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        CHECK(transposed[static_cast<std::size_t>(slot)] == static_cast<double>(10 * column + row));
        ++entries;
    });
    CHECK(entries == 7);
}

}  // namespace gxrod::test
