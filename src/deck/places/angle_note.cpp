#include "deck/places/angle_note.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace gxrod {

std::string describe_many_turns(double angle) {
    constexpr double turn = 2.0 * std::numbers::pi;
    constexpr double slack = 1e-6;
    if (std::abs(angle) <= turn * (1.0 + slack)) return "";
    return fmt::format(
        "{0:.6g} rad are {1:.3g} turns; angles are in rad: {0:.6g} degrees are \"{0:.6g}*pi/180\"",
        angle,
        angle / turn);
}

}  // namespace gxrod
