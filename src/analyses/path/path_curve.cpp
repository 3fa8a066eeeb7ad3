#include "analyses/path/path_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solvers/path/root_search.hpp"

namespace gxrod {

namespace {

double multiply(const PathVector& row, const PathVector& x) { return row.u.dot(x.u) + row.load * x.load; }

// Scaled so that it grows along `row` by `rise`; the straight step where it does not grow.
PathVector scale_to(const PathVector& direction,
                    const PathVector& row,
                    double rise,
                    const PathVector& straight) {
    const double rate = multiply(row, direction);
    return rate * rise > 0.0 ? (rise / rate) * direction : straight;
}

// a + b x + c x² + d x³ on 0 … 1.
struct Cubic {
    double a, b, c, d;
    double operator()(double x) const { return a + x * (b + x * (c + x * d)); }

    // Where it turns within 0 … 1, ascending, and 1.
    std::array<double, 3> list_pieces() const {
        std::array<double, 3> ends{1.0, 1.0, 1.0};
        const double root = c * c - 3.0 * d * b;
        if (root <= 0.0) return ends;
        // Without cancellation.
        const double q = -(c + std::copysign(std::sqrt(root), c));
        std::size_t count = 0;
        for (const double x : {q != 0.0 ? b / q : 1.0, d != 0.0 ? q / (3.0 * d) : 1.0}) {
            if (x > 0.0 && x < 1.0) ends[count++] = x;
        }
        std::sort(ends.begin(), ends.end());
        return ends;
    }
};

}  // namespace

PathCurve::PathCurve(const PathVector& start,
                     const PathVector& end,
                     const PathVector& end_direction,
                     const PathVector& row)
    : start_slope_(scale_to(start, row, multiply(row, end), end)),
      end_(end),
      end_slope_(scale_to(end_direction, row, multiply(row, end), end)) {}

PathVector PathCurve::at(double x) const {
    return (x * (1.0 - x) * (1.0 - x)) * start_slope_ + (x * x * (3.0 - 2.0 * x)) * end_ +
           (x * x * (x - 1.0)) * end_slope_;
}

std::optional<double> PathCurve::find_first(const PathVector& row, double value, double round_off) const {
    const double v = multiply(row, end_), s = multiply(row, start_slope_), e = multiply(row, end_slope_);
    const Cubic all{-value, s, 3.0 * v - 2.0 * s - e, s + e - 2.0 * v};
    // Where it begins there, the other roots are those of a parabola.
    const bool begins_there = std::abs(value) <= round_off;
    const Cubic cubic = begins_there ? Cubic{all.b, all.c, all.d, 0.0} : all;
    double from = 0.0, value_before = cubic(0.0);
    for (const double to : cubic.list_pieces()) {
        const double value_there = to == 1.0 && !begins_there ? v - value : cubic(to);
        if (value_there == 0.0) return to;
        if (value_before * value_there < 0.0) {
            return find_root(
                {from, value_before, to, value_there}, {1e-15, 0.0, 100}, [&](double x) { return cubic(x); });
        }
        from = to;
        value_before = value_there;
    }
    return std::nullopt;
}

}  // namespace gxrod
