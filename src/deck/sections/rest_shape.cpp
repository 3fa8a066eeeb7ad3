#include "deck/sections/rest_shape.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/rods/element_turn.hpp"
#include "deck/sections/rod_sections.hpp"
#include "deck/sections/section_axes.hpp"
#include "geometry/line_curve.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// The curvature, material, of axes along a line: by differences of fourth order; their step is so small
// that what is left is round-off.
Vec3 compute_curvature(const DrawnRod& drawn, std::size_t piece, double fraction, double step) {
    const auto turn = [&](double distance) {
        const Quat before = drawn.axes(piece, fraction - distance);
        return log(before.conjugate() * drawn.axes(piece, fraction + distance));
    };
    const Vec3 by_fraction = (8.0 * turn(step) - turn(2.0 * step)) / (12.0 * step);
    return by_fraction / drawn.line.length();
}

// Of the rest at a place of the reference, zero without components; nullopt with a fault.
std::optional<Vec3> find_rest_curvature(const CheckedPlaceVector* components,
                                        const Vec3& position,
                                        double s,
                                        const BuildContext& context) {
    Vec3 curvature = Vec3::Zero();
    if (components == nullptr) return curvature;
    for (int i = 0; i < 3; ++i) {
        const CheckedPlaceFunction& component = (*components)[static_cast<std::size_t>(i)];
        try {
            curvature[i] = component.expression.function(position, s);
        } catch (const EvaluationError& error) {
            context.add_evaluation_fault(component.place, component.path, error);
            return std::nullopt;
        }
    }
    return curvature;
}

// From the direction that the rest gives, or that of the rod.
std::optional<std::vector<Quat>> find_rest_axes(const RestTable& rest,
                                                const RodTable& rod,
                                                const Centreline& line,
                                                BuildContext& context) {
    if (rest.axes.are_given() || !rod.axes.are_given())
        return find_piece_axes(rest, rest.axes, line, context);
    const Vec3* vector = std::get_if<Vec3>(&*rod.axes.given());
    if (vector == nullptr) return find_piece_axes(rod, rod.axes, line, context);
    if (vector->isZero(0.0)) return std::nullopt;  // a fault of the rod
    const std::optional<Quat> axes = project_axes(rod.axes, line.start_tangent(), context);
    if (axes) return std::vector(line.corners().size() + 1, *axes);
    context.add_fault(
        rest, rest.axes.y_axis, "missing; that of the rod is parallel to the start of the rest");
    return std::nullopt;
}

// The turn of the section axes from the end of an element to the start of the next: nothing, or a corner's.
Quat turn_before(const std::vector<Quat>& triads, std::size_t first) {
    return triads[first - 1].conjugate() * triads[first];
}

// A corner is rigid, so start and rest have the same ones.
void check_corners(const RodTable& table,
                   const std::vector<double>& element_fractions,
                   const Rod& rod,
                   const BuildContext& context) {
    constexpr double same_turn = 1e-9;
    const auto degrees = [](const Quat& turn) { return log(turn).norm() * 180.0 / M_PI; };
    for (std::size_t e = 1; e + 1 < element_fractions.size(); ++e) {
        const std::size_t first = e * (static_cast<std::size_t>(rod.order) + 1);
        const Quat start = turn_before(rod.triads, first);
        const Quat rest = turn_before(rod.rest_triads, first);
        if (start.angularDistance(rest) <= same_turn) continue;
        context.add_fault(
            table,
            table.rest,
            fmt::format("corners are rigid, but at {:.6g} of the length the rest turns by {:.4g}° "
                        "and the start by {:.4g}°{}; expected the same corners, seen from the "
                        "section, or a rod for each piece",
                        element_fractions[e],
                        degrees(rest),
                        degrees(start),
                        std::abs(degrees(rest) - degrees(start)) < 1e-3 ? " another way" : ""));
        return;
    }
}

}  // namespace

std::optional<std::vector<Quat>> find_piece_axes(const TableHead& table,
                                                 const SectionDirections& directions,
                                                 const Centreline& line,
                                                 BuildContext& context) {
    const std::size_t count = line.corners().size() + 1;
    if (!directions.has_rule()) {
        const std::optional<Quat> axes = find_start_axes(table, directions, line.start_tangent(), context);
        return axes ? std::optional(std::vector(count, *axes)) : std::nullopt;
    }
    std::vector<Quat> axes;
    std::size_t vertical = 0;
    for (std::size_t piece = 0; piece < count; ++piece) {
        const Quat to_piece = line.transport(piece, 0.0);
        const Vec3 tangent = to_piece * line.start_tangent();
        axes.push_back(to_piece.conjugate() * *project_axes(directions, tangent, context));
        vertical += is_vertical(tangent, find_up(context)) ? 1 : 0;
    }
    note_vertical(table, directions, "pieces", vertical, count, context);
    return axes;
}

std::optional<RestCurve> find_rest_curve(const RodTable& table,
                                         const SectionTwist& twist,
                                         BuildContext& context) {
    if (!table.rest) return std::nullopt;
    const RestTable& rest = *table.rest;
    if (rest.curvature) {
        const auto refuse = [&](const auto& field) {
            if (field)
                context.add_fault(
                    rest, field, "curvature is in section axes, twist first; expected a curve with it");
        };
        refuse(rest.axes.y_axis);
        refuse(rest.axes.z_axis);
        refuse(rest.twist);
        return std::nullopt;
    }
    std::optional<Centreline> line = find_centreline(rest, context, table.section);
    if (!line) return std::nullopt;
    const auto axes = find_rest_axes(rest, table, *line, context);
    if (!axes) return std::nullopt;
    return RestCurve{std::move(*line), *axes, rest.twist ? SectionTwist(*rest.twist) : twist};
}

RestCurve make_straight_rest(double length, const SectionTwist& twist) {
    std::vector<std::unique_ptr<Curve>> pieces;
    pieces.push_back(std::make_unique<LineCurve>(Vec3::Zero(), length * Vec3::UnitX()));
    return {Centreline(std::move(pieces)), {Quat::Identity()}, twist};
}

void add_corners(const std::vector<double>& corners, RodBreaks& breaks) {
    for (const double corner : corners) {
        const auto is_same = [&](double other) { return std::abs(other - corner) <= same_fraction; };
        if (std::ranges::none_of(breaks.corners, is_same)) breaks.corners.push_back(corner);
    }
    std::ranges::sort(breaks.corners);
}

void set_rest(const RodTable& table,
              const RestCurve& rest,
              const std::vector<double>& element_fractions,
              Rod& rod,
              const BuildContext& context) {
    const std::vector<double> within = compute_element_nodes(rod.order);
    rod.rest_positions.reserve(rod.element_nodes.size());
    rod.rest_triads.reserve(rod.element_nodes.size());
    double largest_turn = 0.0;
    for (std::size_t e = 0; e + 1 < element_fractions.size(); ++e) {
        const double first = element_fractions[e];
        const double last = element_fractions[e + 1];
        const std::size_t piece = rest.line.piece_at(0.5 * (first + last));
        largest_turn = std::max(
            largest_turn,
            compute_element_turn(rest.line.turn(piece, first, last), rest.twist.between(first, last)));
        for (std::size_t i = 0; i < within.size(); ++i) {
            const double fraction = i + 1 == within.size() ? last : first + (last - first) * within[i];
            rod.rest_positions.push_back(rest.line.position(piece, fraction));
            rod.rest_triads.push_back(twisted(rest.line.transport(piece, fraction) * rest.piece_axes[piece],
                                              rest.twist.at(fraction)));
        }
    }
    rod.start_stretch = rod.length / rest.line.length();
    rod.length = rest.line.length();
    for (double& s : rod.arc_length) s /= rod.start_stretch;
    check_corners(table, element_fractions, rod, context);
    check_element_turn(largest_turn, rod.order, table, &table.rest, context);
}

void set_rest(const RodTable& table,
              const DrawnRod& drawn,
              const std::vector<double>& element_fractions,
              Rod& rod,
              const BuildContext& context) {
    // A hung line is straight and without twist where it is free of stress.
    if (!table.rest && !table.catenary) return;
    if (table.rest && !table.rest->curvature) return;  // with a fault
    const CheckedPlaceVector* components = table.rest ? &*table.rest->curvature : nullptr;
    const std::vector<double> points = list_force_points(rod.order);
    std::vector<Vec6> strains;
    for (std::size_t e = 0; e + 1 < element_fractions.size(); ++e) {
        const double first = element_fractions[e];
        const double length = element_fractions[e + 1] - first;
        const std::size_t piece = drawn.line.piece_at(first + 0.5 * length);
        for (const double point : points) {
            const double fraction = first + point * length;
            const auto rest = find_rest_curvature(
                components, drawn.line.position(piece, fraction), fraction * drawn.line.length(), context);
            if (!rest) return;
            Vec6 strain = Vec6::Zero();
            strain.tail<3>() = compute_curvature(drawn, piece, fraction, 1e-3 * length) - *rest;
            strains.push_back(strain);
        }
    }
    rod.rest_strains = std::move(strains);
}

}  // namespace gxrod
