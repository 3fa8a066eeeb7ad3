#pragma once

#include <vector>

#include "model/time/time_function.hpp"

namespace gxrod {

// An interval of time or of a rod.
struct Interval {
    double from = 0.0;
    double to = 0.0;
};

// Find where in the range, without its ends, a switch is crossed or touched: sorted, each once, as exact as
// floating-point numbers allow. Arguments are evaluated at `samples` + 1 places, or where breaks were found
// already, and in between where they come near to a knot. An argument that crosses a knot twice between two
// of these places without coming near it in any is taken to stay.
std::vector<double> find_breaks_in_time(const Switches& switches, const Interval& times, int samples);
std::vector<double> find_breaks_along(const Switches& switches,
                                      double time,
                                      const Interval& rod,
                                      int samples);

}  // namespace gxrod
