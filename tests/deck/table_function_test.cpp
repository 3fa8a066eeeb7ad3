#include "deck/table_function.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

namespace gxrod {

TEST_CASE("A table is linear between rows and held outside", "[deck]") {
    const std::vector<std::pair<double, double>> table{{0.0, 1.0}, {2.0, 5.0}, {3.0, 4.0}};
    CHECK(interpolate(table, -1.0) == 1.0);
    CHECK(interpolate(table, 0.0) == 1.0);
    CHECK(interpolate(table, 0.5) == 2.0);
    CHECK(interpolate(table, 2.0) == 5.0);
    CHECK(interpolate(table, 2.75) == 4.25);
    CHECK(interpolate(table, 3.0) == 4.0);
    CHECK(interpolate(table, std::numeric_limits<double>::infinity()) == 4.0);
    CHECK(std::isnan(interpolate(table, std::numeric_limits<double>::quiet_NaN())));
    CHECK(interpolate({{1.0, 7.0}}, 0.0) == 7.0);
}

TEST_CASE("Between equal rows a table is exactly constant", "[deck]") {
    const std::vector<std::pair<double, double>> table{{0.0, 0.1}, {0.7, 0.1}};
    for (int i = 0; i < 70; ++i) CHECK(interpolate(table, 0.01 * i) == 0.1);
}

}  // namespace gxrod
