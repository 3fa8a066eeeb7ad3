#pragma once

#include <utility>
#include <vector>

namespace gxrod {

// What lies between the rows of a table.
enum class Interpolation {
    linear,
    cubic,  // the spline of cubics with a continuous curvature, without a knot at the second and last but one
            // row
    monotone  // cubics with a continuous slope that rise and fall only where the rows do
};

// The value at `time` of a table of (t, value), t increasing: linear between rows, the first and the last
// value held outside. The table must not be empty.
double interpolate(const std::vector<std::pair<double, double>>& table, double time);

// A table of (t, value), t increasing, as a function: the first and the last value are held outside.
class TableFunction {
  public:
    // There must be a row.
    TableFunction(std::vector<std::pair<double, double>> rows, Interpolation interpolation);

    double operator()(double time) const;
    const std::vector<std::pair<double, double>>& rows() const { return rows_; }

  private:
    std::vector<std::pair<double, double>> rows_;
    std::vector<double> slopes_;  // at the rows; empty where it is linear between them
};

}  // namespace gxrod
