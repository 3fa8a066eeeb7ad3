#include "report/section/colour_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gxrod {
namespace {

using Colour = std::array<double, 3>;

// Even steps of lightness, which colour-blind people can tell apart, too.
constexpr std::array<Colour, 6> scale{
    {{48, 18, 110}, {62, 74, 160}, {44, 123, 150}, {40, 168, 128}, {130, 205, 80}, {250, 230, 60}}};
constexpr std::array<const char*, 8> groups{
    "#9db7d5", "#e3b778", "#a9cf9a", "#d99a9a", "#b7a4d1", "#c8b69f", "#8fcfcf", "#d7d68a"};

}  // namespace

std::string colour_of_value(double value) {
    const double place = std::clamp(value, 0.0, 1.0) * (scale.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), scale.size() - 2);
    const double part = place - static_cast<double>(below);
    const auto mix = [&](std::size_t i) {
        return static_cast<int>(std::lround((1.0 - part) * scale[below][i] + part * scale[below + 1][i]));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2));
}

std::string colour_of_group(std::size_t index) { return groups[index % groups.size()]; }

}  // namespace gxrod
