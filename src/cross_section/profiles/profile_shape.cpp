#include "cross_section/profiles/profile_shape.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cross_section/outlines/outline_examination.hpp"
#include "cross_section/profiles/profile_corners.hpp"

namespace gxrod {
namespace {

// Keeps the first fault found.
class NumberCheck {
  public:
    // The number must be below a bound that is described as "half the height 0.2".
    NumberCheck& below(const char* part, double value, double bound, const char* of, double whole) {
        if (value < bound) return *this;
        return refuse(
            part,
            fmt::format("{:.6g} {} {} {:.6g}", value, value > bound ? "is more than" : "is", of, whole));
    }
    // A radius must not be greater than the room for it, but for round-off.
    NumberCheck& fits(const char* part, double radius, double room) {
        if (radius <= room * (1.0 + 1e-9)) return *this;
        return refuse(
            part, fmt::format("{:.6g} does not fit; expected at most {:.6g}", radius, std::max(room, 0.0)));
    }
    NumberCheck& refuse(const char* part, std::string message) {
        if (!fault_) fault_ = OutlineFault{part, std::move(message)};
        return *this;
    }
    const std::optional<OutlineFault>& fault() const { return fault_; }

  private:
    std::optional<OutlineFault> fault_;
};

std::optional<OutlineFault> check(const IShape& shape) {
    return NumberCheck()
        .below("web", shape.web, shape.width, "the width", shape.width)
        .below("flange", shape.flange, 0.5 * shape.height, "half the height", shape.height)
        .fits("fillet",
              shape.fillet,
              std::min(0.5 * (shape.width - shape.web), 0.5 * shape.height - shape.flange))
        .fault();
}

std::optional<OutlineFault> check(const ChannelShape& shape) {
    const double tip = find_flange_thickness(shape, shape.width);
    const double root = find_flange_thickness(shape, shape.web);
    NumberCheck numbers;
    numbers.below("web", shape.web, shape.width, "the width", shape.width)
        .below("flange", shape.flange, 0.5 * shape.height, "half the height", shape.height);
    if (!(tip > 0.0))
        numbers.refuse("slope",
                       fmt::format("{:.6g} leaves no flange at its end; expected less", shape.slope));
    if (!(root < 0.5 * shape.height))
        numbers.refuse("slope",
                       fmt::format("{:.6g} makes the flanges meet at the web; expected less", shape.slope));
    // Tangents of arcs between a wall and a sloping face.
    const double angle = std::atan(shape.slope);
    const double of_fillet = std::tan(0.25 * M_PI - 0.5 * angle),
                 of_toe = std::tan(0.25 * M_PI + 0.5 * angle);
    const double inside = std::hypot(shape.width - shape.web, root - tip);
    return numbers.fits("toe", shape.toe, std::min(tip, inside) / of_toe)
        .fits("fillet",
              shape.fillet,
              std::min(0.5 * shape.height - root, inside - shape.toe * of_toe) / of_fillet)
        .fault();
}

std::optional<OutlineFault> check(const AngleShape& shape) {
    const double shorter = std::min(shape.width, shape.height);
    return NumberCheck()
        .below("wall", shape.wall, shorter, "the leg", shorter)
        .fits("toe", shape.toe, std::min(shape.wall, shorter - shape.wall))
        .fits("fillet", shape.fillet, shorter - shape.wall - shape.toe)
        .fault();
}

std::optional<OutlineFault> check(const TeeShape& shape) {
    return NumberCheck()
        .below("web", shape.web, shape.width, "the width", shape.width)
        .below("flange", shape.flange, shape.height, "the height", shape.height)
        .fits("fillet", shape.fillet, std::min(0.5 * (shape.width - shape.web), shape.height - shape.flange))
        .fault();
}

std::optional<OutlineFault> check(const BoxShape& shape) {
    const auto& [height, width, wall, flange, outer_radius, inner_radius] = shape;
    NumberCheck numbers;
    numbers.below("wall", wall, 0.5 * width, "half the width", width)
        .below("flange", flange, 0.5 * height, "half the height", height)
        .fits("outer_radius", outer_radius, 0.5 * std::min(width, height))
        .fits("inner_radius", inner_radius, std::min(0.5 * width - wall, 0.5 * height - flange));
    if (!numbers.fault() && find_fault(list_corners(shape))) {
        numbers.refuse("outer_radius",
                       fmt::format("{:.6g} leaves no wall at the corners where inner_radius is {:.6g}",
                                   outer_radius,
                                   inner_radius));
    }
    return numbers.fault();
}

std::optional<OutlineFault> check(const ZedShape& shape) {
    return NumberCheck()
        .below("wall", shape.wall, shape.width, "the width", shape.width)
        .below("wall", shape.wall, 0.5 * shape.height, "half the height", shape.height)
        .fits("radius", shape.radius.value_or(0.0), std::min(shape.width, 0.5 * shape.height) - shape.wall)
        .fault();
}

std::optional<OutlineFault> check(const HatShape& shape) {
    const double half = std::min(0.5 * shape.width, 0.5 * shape.height);
    return NumberCheck()
        .below("wall", shape.wall, 0.5 * shape.width, "half the width", shape.width)
        .below("wall", shape.wall, 0.5 * shape.height, "half the height", shape.height)
        .fits("radius", shape.radius.value_or(0.0), std::min(half - shape.wall, shape.foot))
        .fault();
}

std::optional<OutlineFault> check(const HollowCircle& shape) {
    return NumberCheck()
        .below("wall", shape.wall, 0.5 * shape.diameter, "half the diameter", shape.diameter)
        .fault();
}

Outline draw(const HollowCircle& shape) {
    return draw_ring(0.5 * shape.diameter, 0.5 * shape.diameter - shape.wall);
}

template <class Shape>
Outline draw(const Shape& shape) {
    return draw_outline(list_corners(shape));
}

}  // namespace

std::optional<OutlineFault> find_fault(const ProfileShape& shape) {
    return std::visit([](const auto& one) { return check(one); }, shape);
}

Outline draw_outline(const ProfileShape& shape) {
    return std::visit([](const auto& one) { return draw(one); }, shape);
}

}  // namespace gxrod
