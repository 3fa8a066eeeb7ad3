#include "model/spring_law.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {
namespace {

// Of an argument: the cube root of a double's round-off, where that of the difference and its truncation are
// about the same.
constexpr double share = 6e-6;

}  // namespace

double SpringLaw::differentiate_by_length(double length, double rate) const {
    const double step = share * std::max(length, start_);
    return (force_(length + step, rate) - force_(length - step, rate)) / (2.0 * step);
}

double SpringLaw::differentiate_by_rate(double length, double rate, double rates) const {
    constexpr double share_at_rest = 0.1;
    const double size = share_at_rest * std::abs(rates) * std::max(length, start_);
    const double step = share * std::max(std::abs(rate), size);
    if (!(step > 0.0)) return 0.0;
    return (force_(length, rate + step) - force_(length, rate - step)) / (2.0 * step);
}

}  // namespace gxrod
