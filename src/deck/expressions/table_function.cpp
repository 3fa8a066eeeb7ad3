#include "deck/expressions/table_function.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gxrod {

double interpolate(const std::vector<std::pair<double, double>>& table, double time) {
    assert(!table.empty());
    if (std::isnan(time)) return time;
    const auto later = std::upper_bound(
        table.begin(), table.end(), time, [](double t, const auto& row) { return t < row.first; });
    if (later == table.begin()) return table.front().second;
    if (later == table.end()) return table.back().second;
    const auto& [t0, value0] = *(later - 1);
    const auto& [t1, value1] = *later;
    return value0 + (value1 - value0) * ((time - t0) / (t1 - t0));
}

namespace {

using Rows = std::vector<std::pair<double, double>>;

double width_of(const Rows& rows, std::size_t i) { return rows[i + 1].first - rows[i].first; }
double secant_of(const Rows& rows, std::size_t i) {
    return (rows[i + 1].second - rows[i].second) / width_of(rows, i);
}

// Slopes of the spline through three rows or more: continuous curvature at all rows but the first and the
// last, and one cubic across the second and across the last but one ("not a knot"). With C. de Boor, A
// Practical Guide to Splines (1978), chapter IV: one equation a row, of the slopes of it and its neighbours.
std::vector<double> find_spline_slopes(const Rows& rows) {
    const std::size_t n = rows.size();
    std::vector<double> slopes(n), diagonal(n), upper(n);
    if (n == 3) {
        // One parabola.
        const double curvature = (secant_of(rows, 1) - secant_of(rows, 0)) / (rows[2].first - rows[0].first);
        slopes[0] = secant_of(rows, 0) - curvature * width_of(rows, 0);
        slopes[1] = secant_of(rows, 0) + curvature * width_of(rows, 0);
        slopes[2] = secant_of(rows, 1) + curvature * width_of(rows, 1);
        return slopes;
    }
    const double first = width_of(rows, 0);
    const double second = width_of(rows, 1);
    diagonal[0] = second;
    upper[0] = first + second;
    slopes[0] =
        ((first + 2.0 * upper[0]) * second * secant_of(rows, 0) + first * first * secant_of(rows, 1)) /
        upper[0];
    for (std::size_t i = 1; i + 1 < n; ++i) {
        // width[i] s[i−1] + 2 (width[i−1] + width[i]) s[i] + width[i−1] s[i+1] = right
        const double before = width_of(rows, i - 1);
        const double after = width_of(rows, i);
        const double factor = after / diagonal[i - 1];
        diagonal[i] = 2.0 * (before + after) - factor * upper[i - 1];
        upper[i] = before;
        slopes[i] =
            3.0 * (after * secant_of(rows, i - 1) + before * secant_of(rows, i)) - factor * slopes[i - 1];
    }
    const double last = width_of(rows, n - 2);
    const double last_but_one = width_of(rows, n - 3);
    const double both = last + last_but_one;
    const double right =
        (last * last * secant_of(rows, n - 3) + (2.0 * both + last) * last_but_one * secant_of(rows, n - 2)) /
        both;
    const double factor = both / diagonal[n - 2];
    slopes[n - 1] = (right - factor * slopes[n - 2]) / (last_but_one - factor * upper[n - 2]);
    for (std::size_t i = n - 1; i-- > 0;) slopes[i] = (slopes[i] - upper[i] * slopes[i + 1]) / diagonal[i];
    return slopes;
}

// At an end, from the two secants next to it and the widths that they span: of the parabola through three
// rows, but none that would turn the cubic round.
double find_monotone_end(double width, double next_width, double secant, double next_secant) {
    const double slope = ((2.0 * width + next_width) * secant - width * next_secant) / (width + next_width);
    if (slope * secant <= 0.0) return 0.0;
    if (secant * next_secant <= 0.0 && std::abs(slope) > 3.0 * std::abs(secant)) return 3.0 * secant;
    return slope;
}

// F. N. Fritsch and J. Butland, A Method for Constructing Local Monotone Piecewise Cubic Interpolants, SIAM
// J. Sci. Stat. Comput. 5 (1984): 0 where the secants change sign, their weighted harmonic mean elsewhere.
std::vector<double> find_monotone_slopes(const Rows& rows) {
    const std::size_t n = rows.size();
    std::vector<double> slopes(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = secant_of(rows, i - 1);
        const double after = secant_of(rows, i);
        if (before * after <= 0.0) continue;
        const double w1 = 2.0 * width_of(rows, i) + width_of(rows, i - 1);
        const double w2 = width_of(rows, i) + 2.0 * width_of(rows, i - 1);
        slopes[i] = (w1 + w2) / (w1 / before + w2 / after);
    }
    slopes.front() =
        find_monotone_end(width_of(rows, 0), width_of(rows, 1), secant_of(rows, 0), secant_of(rows, 1));
    slopes.back() = find_monotone_end(
        width_of(rows, n - 2), width_of(rows, n - 3), secant_of(rows, n - 2), secant_of(rows, n - 3));
    return slopes;
}

}  // namespace

TableFunction::TableFunction(std::vector<std::pair<double, double>> rows, Interpolation interpolation)
    : rows_(std::move(rows)) {
    assert(!rows_.empty());
    // Two rows are a straight line by any of them.
    if (interpolation == Interpolation::linear || rows_.size() < 3) return;
    slopes_ = interpolation == Interpolation::cubic ? find_spline_slopes(rows_) : find_monotone_slopes(rows_);
}

double TableFunction::operator()(double time) const {
    if (slopes_.empty() || !(time > rows_.front().first && time < rows_.back().first)) {
        return interpolate(rows_, time);
    }
    const auto later = std::upper_bound(
        rows_.begin(), rows_.end(), time, [](double t, const auto& row) { return t < row.first; });
    const auto i = static_cast<std::size_t>(later - rows_.begin()) - 1;
    const double width = width_of(rows_, i);
    const double u = (time - rows_[i].first) / width;
    const double v = 1.0 - u;
    // Hermite's cubic.
    return rows_[i].second * (1.0 + 2.0 * u) * v * v + rows_[i + 1].second * (1.0 + 2.0 * v) * u * u +
           width * u * v * (slopes_[i] * v - slopes_[i + 1] * u);
}

}  // namespace gxrod
