#include "laws/piecewise_line.hpp"

#include <cassert>

namespace gxrod {

PiecewiseLine::PiecewiseLine(std::vector<std::pair<double, double>> points)
    : points_(std::move(points)), integrals_{0.0} {
    assert(points_.size() > 1 && points_.front().first == 0.0);
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        const auto& [x, y] = points_[i];
        const auto& [next_x, next_y] = points_[i + 1];
        integrals_.push_back(integrals_.back() + 0.5 * (y + next_y) * (next_x - x));
    }
}

double PiecewiseLine::slope(std::size_t i) const {
    const auto& [x, y] = points_[i];
    const auto& [next_x, next_y] = points_[i + 1];
    return (next_y - y) / (next_x - x);
}

PiecewiseLine::Value PiecewiseLine::at(double x) const {
    std::size_t i = 0;
    while (i + 2 < points_.size() && x > points_[i + 1].first) ++i;
    const double from = x - points_[i].first;
    const double start = points_[i].second;
    const double rise = slope(i);
    return {start + rise * from, rise, integrals_[i] + from * (start + 0.5 * rise * from)};
}

}  // namespace gxrod
