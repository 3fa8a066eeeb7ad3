#pragma once

#include <vector>

#include "model/time/time_function.hpp"

namespace gxrod {

// A part of the time or of a rod.
struct Interval {
    double from = 0.0;
    double to = 0.0;
};

// Where in the range, without its ends, a switch is crossed or touched: sorted, each once, as exact as
// floating-point numbers allow. The arguments are looked at in `samples` + 1 places, where these have been
// found already, and between them where they come near to a knot. One that turns to and fro between two of
// these places without coming nearer in any is taken to stay.
std::vector<double> find_breaks_in_time(const Switches& switches, const Interval& times, int samples);
std::vector<double> find_breaks_along(const Switches& switches,
                                      double time,
                                      const Interval& rod,
                                      int samples);

}  // namespace gxrod
