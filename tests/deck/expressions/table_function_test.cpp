#include "deck/expressions/table_function.hpp"

#include <cmath>
#include <limits>

#include "tools/catch.hpp"

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

TEST_CASE("A cubic table is a cubic where its rows are of one", "[deck]") {
    const auto cubic = [](double t) { return 1.0 - 2.0 * t + 0.5 * t * t - 0.3 * t * t * t; };
    std::vector<std::pair<double, double>> rows;
    for (const double t : {-1.0, 0.0, 0.4, 1.7, 2.0, 3.5}) rows.emplace_back(t, cubic(t));
    const TableFunction table(rows, Interpolation::cubic);
    for (int i = 0; i <= 90; ++i) {
        const double t = -1.0 + 0.05 * i;
        CHECK(std::abs(table(t) - cubic(t)) < 1e-13);
    }
    CHECK(table(-2.0) == cubic(-1.0));
    CHECK(table(4.0) == cubic(3.5));
    // Three rows are a parabola, two a straight line.
    const TableFunction parabola({{0.0, 0.0}, {1.0, 1.0}, {3.0, 9.0}}, Interpolation::cubic);
    CHECK(parabola(2.0) == Approx(4.0).epsilon(1e-14));
    CHECK(TableFunction({{0.0, 0.0}, {2.0, 6.0}}, Interpolation::cubic)(0.5) == 1.5);
}

TEST_CASE("A cubic table has a continuous curvature and errs by the fourth power of the rows' distance",
          "[deck]") {
    const auto make = [](int count) {
        std::vector<std::pair<double, double>> rows;
        for (int i = 0; i <= count; ++i) rows.emplace_back(6.0 * i / count, std::sin(6.0 * i / count));
        return TableFunction(rows, Interpolation::cubic);
    };
    const auto error_of = [&](int count) {
        const TableFunction table = make(count);
        double error = 0.0;
        for (int i = 0; i <= 1000; ++i)
            error = std::max(error, std::abs(table(0.006 * i) - std::sin(0.006 * i)));
        return error;
    };
    CHECK(std::log2(error_of(24) / error_of(48)) == Approx(4.0).margin(0.4));
    const TableFunction table = make(12);
    for (int i = 1; i < 12; ++i) {
        const double h = 1e-4;
        const auto curvature = [&](double t) {
            return (table(t + h) - 2.0 * table(t) + table(t - h)) / (h * h);
        };
        // Cubics have a linear curvature: from two places on each side to the row.
        const double at = 0.5 * i;
        const double before = 2.0 * curvature(at - 0.01) - curvature(at - 0.02);
        const double after = 2.0 * curvature(at + 0.01) - curvature(at + 0.02);
        CHECK(std::abs(before - after) < 1e-5);
    }
}

TEST_CASE("A monotone table rises and falls only where its rows do", "[deck]") {
    const std::vector<std::pair<double, double>> rows{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 3}, {4.5, -1}};
    const TableFunction monotone(rows, Interpolation::monotone);
    const TableFunction cubic(rows, Interpolation::cubic);
    double cubic_overshoot = 0.0;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        const auto [low, high] = std::minmax(rows[i].second, rows[i + 1].second);
        double before = rows[i].second;
        for (int k = 1; k <= 20; ++k) {
            const double t = rows[i].first + (rows[i + 1].first - rows[i].first) * k / 20.0;
            const double value = monotone(t);
            CHECK(value >= low - 1e-15);
            CHECK(value <= high + 1e-15);
            CHECK((value - before) * (rows[i + 1].second - rows[i].second) >= -1e-15);
            before = value;
            cubic_overshoot = std::max({cubic_overshoot, low - cubic(t), cubic(t) - high});
        }
        // Its slope is continuous.
        if (i == 0) continue;
        const double h = 1e-6;
        const double left = (monotone(rows[i].first) - monotone(rows[i].first - h)) / h;
        const double right = (monotone(rows[i].first + h) - monotone(rows[i].first)) / h;
        CHECK(std::abs(left - right) < 1e-3);
    }
    CHECK(cubic_overshoot > 0.05);
}

}  // namespace gxrod
