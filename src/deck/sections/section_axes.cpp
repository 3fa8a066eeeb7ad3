#include "deck/sections/section_axes.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "rotation/rotation_map.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {
namespace {

// The sine of an angle that counts as zero.
constexpr double zero_angle = 1e-6;
constexpr double round_off = 1e-12;  // of an axis

struct GlobalAxis {
    char name;
    Vec3 direction;
};

// The global axis least aligned with a tangent; of equals the first of y, z, x, so that a rod along x, y or z
// has section axes along the global ones.
GlobalAxis choose_y_axis(const Vec3& tangent) {
    const std::array<GlobalAxis, 3> axes{{{'y', Vec3::UnitY()}, {'z', Vec3::UnitZ()}, {'x', Vec3::UnitX()}}};
    GlobalAxis chosen = axes[0];
    for (const GlobalAxis& axis : axes) {
        if (std::abs(axis.direction.dot(tangent)) < std::abs(chosen.direction.dot(tangent)) - 1e-9)
            chosen = axis;
    }
    return chosen;
}

}  // namespace

std::optional<Quat> project_axes(const Vec3& tangent, const Vec3& y_axis) {
    const Vec3 direction = y_axis.stableNormalized();
    const Vec3 projected = direction - direction.dot(tangent) * tangent;
    if (projected.norm() < zero_angle) return std::nullopt;
    const Vec3 y = projected.normalized();
    Mat3 axes;
    axes << tangent, y, tangent.cross(y);
    return Quat(axes).normalized();
}

Quat choose_axes(const Vec3& tangent) { return *project_axes(tangent, choose_y_axis(tangent).direction); }

std::optional<Quat> find_start_axes(const TableHead& table,
                                    const std::optional<Vec3>& y_axis,
                                    const Vec3& tangent,
                                    BuildContext& context) {
    if (!y_axis) {
        Quat axes = choose_axes(tangent);
        context.notes.push_back(fmt::format("{}: not given; section y at the start is {}, from global {}",
                                            table.path_of(&y_axis),
                                            in_brackets(axes * Vec3::UnitY(), 6, round_off),
                                            choose_y_axis(tangent).name));
        return axes;
    }
    if (y_axis->isZero(0.0)) {
        context.add_fault(table, y_axis, "expected a direction, found a vector of zero length");
        return std::nullopt;
    }
    std::optional<Quat> axes = project_axes(tangent, *y_axis);
    if (!axes) {
        context.add_fault(
            table,
            y_axis,
            "parallel to the rod, so that section y is not defined; expected another direction");
    }
    return axes;
}

Quat twisted(const Quat& axes, double angle) {
    return angle == 0.0 ? axes : axes * exp_quaternion(angle * Vec3::UnitX());
}

}  // namespace gxrod
