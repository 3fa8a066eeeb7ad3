#pragma once

#include <cmath>

namespace gxrod {

// A part of a catenary in its upright plane, from a point on it: x is level, z is up. The slope dz/dx is
// linear in the arc length, with the `rate` 1/a, where a is the level part of the tension over the weight per
// length. The formulas have no cancellation if the part is nearly straight or nearly upright.
struct Catenary {
    double slope;       // at the point
    double rate = 0.0;  // 0 makes a straight line

    struct Point {
        double x, z;
    };
    double slope_at(double s) const { return slope + rate * s; }
    // s can be negative.
    Point point_at(double s) const {
        const double slope_there = slope_at(s);
        const double here = std::hypot(1.0, slope), there = std::hypot(1.0, slope_there);
        const double product = slope * slope_there;
        // The cosh of the difference of the arsinh of both slopes.
        const double factor =
            product > 0.0 ? (1.0 + slope * slope + slope_there * slope_there) / (here * there + product)
                          : here * there - product;
        const double mean = (1.0 + factor) / (here + there);
        const double difference = std::asinh(rate * s * mean);
        const double x = rate * s * mean == 0.0 ? s * mean : difference / rate;
        return {x, s * (slope + slope_there) / (here + there)};
    }
};

// Finds x = X/(2a) with sinh x / x = ratio, for the span X of a catenary; log_ratio = ln(ratio) > 0.
double find_catenary_argument(double log_ratio);

}  // namespace gxrod
