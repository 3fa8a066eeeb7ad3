#include "deck/sections/section_axes.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "deck/loads/gravity_table.hpp"
#include "deck/schema/top_level.hpp"
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

// Beyond this part of a unit vector `up` is along a global axis, of which there must be another.
constexpr double mostly = 0.9;

// Axes from a unit tangent and a direction of section y, or z, projected; nullopt if they are parallel.
std::optional<Quat> project_section_axes(const Vec3& tangent, const Vec3& given, bool is_z) {
    const Vec3 direction = given.stableNormalized();
    const Vec3 projected = direction - direction.dot(tangent) * tangent;
    if (projected.norm() < zero_angle) return std::nullopt;
    const Vec3 across = projected.normalized();
    Mat3 axes;
    if (is_z) {
        axes << tangent, across.cross(tangent), across;
    } else {
        axes << tangent, across, tangent.cross(across);
    }
    return Quat(axes).normalized();
}

// The direction that a rule takes instead of `up` where a rod goes along it: global x, or y where x is up.
GlobalAxis find_other_axis(const Vec3& up) {
    return std::abs(up.x()) > mostly ? GlobalAxis{'y', Vec3::UnitY()} : GlobalAxis{'x', Vec3::UnitX()};
}

Vec3 find_axis_direction(const AxisDirection& given, const Vec3& tangent, const BuildContext& context) {
    if (const Vec3* vector = std::get_if<Vec3>(&given)) return *vector;
    const Vec3 up = find_up(context);
    return is_vertical(tangent, up) ? find_other_axis(up).direction : up;
}

}  // namespace

std::optional<Quat> project_axes(const SectionDirections& directions,
                                 const Vec3& tangent,
                                 const BuildContext& context) {
    const bool is_z = directions.z_axis.has_value();
    return project_section_axes(tangent, find_axis_direction(*directions.given(), tangent, context), is_z);
}

Quat choose_axes(const Vec3& tangent) {
    return *project_section_axes(tangent, choose_y_axis(tangent).direction, false);
}

Vec3 find_up(const BuildContext& context) {
    const TopLevelTable& top = top_level_of(context.deck);
    Vec3 gravity = Vec3::Zero();
    try {
        const CheckedTimeVector* given = find_gravity(context.deck);
        for (int i = 0; given != nullptr && i < 3; ++i)
            gravity[i] = (*given)[static_cast<std::size_t>(i)].function(1.0);
    } catch (const EvaluationError&) {
        gravity.setZero();  // what has no value is a fault of its own
    }
    if (gravity.allFinite() && !gravity.isZero(0.0)) return -gravity.stableNormalized();
    return top.plane == PlaneAcross::xy ? Vec3::UnitY() : Vec3::UnitZ();
}

// Frame programs take a member for vertical where the sine of its angle is below this.
bool is_vertical(const Vec3& tangent, const Vec3& up) {
    constexpr double vertical = 1e-3;
    return tangent.cross(up).norm() < vertical;
}

void note_vertical(const TableHead& table,
                   const SectionDirections& directions,
                   const std::string& kind,
                   std::size_t count,
                   std::size_t all,
                   BuildContext& context) {
    if (count == 0) return;
    const Vec3 up = find_up(context);
    const char axis = directions.z_axis ? 'z' : 'y';
    const std::string what = all == 1 ? "the rod is" : fmt::format("{} of {} {} are", count, all, kind);
    context.notes.push_back(fmt::format("{}: up is {}; {} vertical, with section {} from global {}",
                                        table.path_of(&directions.given()),
                                        in_brackets(up, 6, round_off),
                                        what,
                                        axis,
                                        find_other_axis(up).name));
}

std::optional<Quat> find_start_axes(const TableHead& table,
                                    const SectionDirections& directions,
                                    const Vec3& tangent,
                                    BuildContext& context) {
    const void* field = &directions.given();
    if (!directions.are_given()) {
        Quat axes = choose_axes(tangent);
        context.notes.push_back(fmt::format("{}: not given; section y at the start is {}, from global {}",
                                            table.path_of(field),
                                            in_brackets(axes * Vec3::UnitY(), 6, round_off),
                                            choose_y_axis(tangent).name));
        return axes;
    }
    const auto refuse = [&](const std::string& message) {
        context.faults.add(table.place_of(field), table.path_of(field), message);
    };
    const Vec3* vector = std::get_if<Vec3>(&*directions.given());
    if (vector != nullptr && vector->isZero(0.0)) {
        refuse("expected a direction, found a vector of zero length");
        return std::nullopt;
    }
    std::optional<Quat> axes = project_axes(directions, tangent, context);
    if (!axes)
        refuse(
            fmt::format("parallel to the rod, so that section {} is not defined; expected another direction",
                        directions.z_axis ? 'z' : 'y'));
    return axes;
}

Quat twisted(const Quat& axes, double angle) {
    return angle == 0.0 ? axes : axes * exp_quaternion(angle * Vec3::UnitX());
}

}  // namespace gxrod
