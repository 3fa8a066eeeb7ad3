#pragma once

#include <optional>

#include "solvers/path/path_metric.hpp"

namespace gxrod {

// A step of a path as the cubic curve with the same ends and end directions (Hermite).
class PathCurve {
  public:
    // Makes the curve from zero along `start` to `end`, where the direction is `end_direction`. The product
    // of `row` with places on the path grows along the step and is the parameter of the curve.
    PathCurve(const PathVector& start,
              const PathVector& end,
              const PathVector& end_direction,
              const PathVector& row);

    // Returns the place at a part of the step, from 0 to 1.
    PathVector at(double part) const;
    // Finds the first part beyond 0 at which the product of this row with the curve is `value`; nullopt if
    // there is none up to 1. If the product has the value at 0 already, within `round_off`, that does not
    // count.
    std::optional<double> find_first(const PathVector& row, double value, double round_off) const;

  private:
    PathVector start_slope_, end_, end_slope_;  // derivatives by the part
};

}  // namespace gxrod
