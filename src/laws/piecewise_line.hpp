#pragma once

#include <utility>
#include <vector>

namespace gxrod {

// A function on x ≥ 0 by points, linear in between and beyond the last one.
class PiecewiseLine {
  public:
    struct Value {
        double value, slope, integral;  // the integral from 0
    };

    // Takes two points or more, the first at x = 0, x increasing.
    explicit PiecewiseLine(std::vector<std::pair<double, double>> points);

    Value at(double x) const;
    const std::vector<std::pair<double, double>>& points() const { return points_; }
    // Returns the slope between point i and the next one.
    double slope(std::size_t i) const;
    std::size_t piece_count() const { return points_.size() - 1; }

  private:
    std::vector<std::pair<double, double>> points_;
    std::vector<double> integrals_;  // up to each point
};

}  // namespace gxrod
