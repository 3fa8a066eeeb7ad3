#include "numerics/smooth_line.hpp"
#include "tools/catch.hpp"

#include <cmath>
#include <vector>

using gxrod::SmoothLine;

namespace {

// The line's value at s on a piece, or its slope, of values given at its points.
double evaluate(
    const SmoothLine& line, const std::vector<double>& values, int index, double s, int order = 0) {
    const SmoothLine::Piece& piece = line.pieces()[static_cast<std::size_t>(index)];
    const auto weights = piece.compute_weights<2>(s);
    double sum = 0.0;
    for (int i = 0; i < piece.count; ++i) {
        sum += values[static_cast<std::size_t>(piece.first + i)] *
               weights[static_cast<std::size_t>(order)][static_cast<std::size_t>(i)];
    }
    return sum;
}

std::vector<double> sample(const std::vector<double>& at, double (*function)(double)) {
    std::vector<double> values;
    for (const double s : at) values.push_back(function(s));
    return values;
}

std::vector<double> divide(int count) {
    std::vector<double> at;
    for (int i = 0; i <= count; ++i) at.push_back(2.0 * i / count);
    return at;
}

// The largest errors of values and slopes between points.
std::pair<double, double> measure_errors(int count) {
    const std::vector<double> at = divide(count);
    const SmoothLine line(at);
    const std::vector<double> values = sample(at, [](double s) { return std::sin(3.0 * s); });
    double of_values = 0.0, of_slopes = 0.0;
    for (int k = 0; k <= 1000; ++k) {
        const double s = 2e-3 * k;
        const int piece = line.find_piece(s);
        of_values = std::max(of_values, std::abs(evaluate(line, values, piece, s) - std::sin(3.0 * s)));
        of_slopes =
            std::max(of_slopes, std::abs(evaluate(line, values, piece, s, 1) - 3.0 * std::cos(3.0 * s)));
    }
    return {of_values, of_slopes};
}

}  // namespace

TEST_CASE("A smooth line goes through its points, and is a polynomial of degree 4 where they are on one",
          "[numerics][sleeve]") {
    for (const std::vector<double>& at : {std::vector<double>{0.0, 0.3, 0.4, 1.0, 1.3, 1.9, 2.0, 2.4},
                                          std::vector<double>{0.0, 0.2, 0.5, 0.6, 1.0},
                                          std::vector<double>{0.5, 0.7, 0.8, 1.0, 1.2, 2.0}}) {
        const SmoothLine line(at);
        const auto quartic = [](double s) { return 1.0 - 2.0 * s + s * s - 0.7 * std::pow(s, 4); };
        const std::vector<double> values = sample(at, quartic);
        REQUIRE(line.pieces().size() + 1 == at.size());
        for (double s = at.front(); s < at.back(); s += 0.01) {
            const int piece = line.find_piece(s);
            CHECK(evaluate(line, values, piece, s) == Approx(quartic(s)).margin(1e-12));
            CHECK(evaluate(line, values, piece, s, 1) ==
                  Approx(-2.0 + 2.0 * s - 2.8 * std::pow(s, 3)).margin(1e-11));
        }
    }
}

TEST_CASE("Through two points a line is straight, through three a parabola", "[numerics][sleeve]") {
    CHECK(evaluate(SmoothLine({1.0, 3.0}), {4.0, 8.0}, 0, 1.5) == Approx(5.0));
    const SmoothLine three({0.0, 1.0, 3.0});
    CHECK(evaluate(three, {0.0, 1.0, 9.0}, 1, 2.0) == Approx(4.0));
    CHECK(evaluate(three, {0.0, 1.0, 9.0}, 0, 0.5, 1) == Approx(1.0));
}

TEST_CASE("The tangent of a smooth line is continuous", "[numerics][sleeve]") {
    const std::vector<double> at{0.0, 0.3, 0.4, 1.0, 1.3, 1.9, 2.0, 2.4};
    const std::vector<double> values{0.0, 1.0, -0.4, 0.2, 0.9, -1.0, 0.3, 0.5};
    const SmoothLine line(at);
    for (int i = 1; i + 1 < static_cast<int>(at.size()); ++i) {
        const double s = at[static_cast<std::size_t>(i)];
        CHECK(evaluate(line, values, i - 1, s) == Approx(values[static_cast<std::size_t>(i)]));
        CHECK(evaluate(line, values, i, s) == Approx(values[static_cast<std::size_t>(i)]));
        CHECK(evaluate(line, values, i - 1, s, 1) == Approx(evaluate(line, values, i, s, 1)));
    }
}

TEST_CASE("A smooth line is of order 5, its tangent of order 4", "[numerics][sleeve]") {
    const auto coarse = measure_errors(20);
    const auto fine = measure_errors(40);
    CHECK(std::log2(coarse.first / fine.first) == Approx(5.0).margin(0.3));
    CHECK(std::log2(coarse.second / fine.second) == Approx(4.0).margin(0.3));
}
