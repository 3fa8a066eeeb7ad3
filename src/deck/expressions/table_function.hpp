#pragma once

#include <utility>
#include <vector>

namespace gxrod {

// The interpolation between the rows of a table.
enum class Interpolation {
    linear,
    cubic,  // the spline of cubics with a continuous curvature, without a knot at the second and last but one
            // row
    monotone  // cubics with a continuous slope that rise and fall only where the rows do
};

// Returns the value at `time` of a table of (t, value), t increasing: linear between rows, the first or last
// value outside. The table must not be empty.
double interpolate(const std::vector<std::pair<double, double>>& table, double time);

// A table of (t, value), t increasing, as a function; outside it has the first or last value.
class TableFunction {
  public:
    // Needs at least one row.
    TableFunction(std::vector<std::pair<double, double>> rows, Interpolation interpolation);

    double operator()(double time) const;
    const std::vector<std::pair<double, double>>& rows() const { return rows_; }

  private:
    std::vector<std::pair<double, double>> rows_;
    std::vector<double> slopes_;  // at the rows; empty if it is linear between them
};

}  // namespace gxrod
