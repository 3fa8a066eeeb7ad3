#pragma once

#include <optional>

#include "solvers/path/path_metric.hpp"

namespace gxrod {

// A step of a path as the cubic curve that has its ends and its directions there (Hermite).
class PathCurve {
  public:
    // From zero along `start` to `end`, where the direction is `end_direction`. `row` grows along the step:
    // its product with places on the path is what the curve is a function of.
    PathCurve(const PathVector& start,
              const PathVector& end,
              const PathVector& end_direction,
              const PathVector& row);

    // At a part of the step, from 0 to 1.
    PathVector at(double part) const;
    // The first part beyond 0 at which the product of this row with the curve is `value`; nullopt if there is
    // none up to 1. Near 0, where it has the value already, within `round_off`, that does not count.
    std::optional<double> find_first(const PathVector& row, double value, double round_off) const;

  private:
    PathVector start_slope_, end_, end_slope_;  // by the part
};

}  // namespace gxrod
