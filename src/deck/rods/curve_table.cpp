#include "deck/rods/curve_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "deck/rods/still_water.hpp"
#include "deck/schema/schema_tables.hpp"
#include "geometry/helix_curve.hpp"
#include "geometry/hung_line.hpp"
#include "geometry/line_curve.hpp"
#include "geometry/natural_spline.hpp"
#include "mesh/rod_mesh.hpp"

namespace gxrod {
namespace {

const TableSpec& line_table() {
    using T = LineTable;
    // clang-format off
    static const TableSpec table = Table<T>("rod.NAME.line", "")
        .key("from", &T::from, "Where the rod starts.")
            .unit("length").required().also("start begin p1 a")
        .key("to", &T::to, "Where it ends.")
            .unit("length").required().also("end p2 b");
    // clang-format on
    return table;
}

const TableSpec& arc_table() {
    using T = ArcTable;
    // clang-format off
    static const TableSpec table = Table<T>("rod.NAME.arc", "")
        .key("from", &T::from, "Where the arc starts.")
            .unit("length").required()
        .key("through", &T::through, "A point between its ends.")
            .unit("length")
        .key("to", &T::to, "Where it ends.")
            .unit("length").required().only_with("through")
        .key("centre", &T::centre, "Its centre.")
            .unit("length")
        .key("axis", &T::axis, "Normal to its plane.")
            .unit("1").required().only_with("centre")
        .key("angle", &T::angle, "Turned about the axis from start to end, right-handed; \"2*pi\" is a circle.")
            .unit("angle").between(-2.0 * M_PI, 2.0 * M_PI).required().only_with("centre")
        .exactly_one_of({"through", "centre"});
    // clang-format on
    return table;
}

const TableSpec& helix_table() {
    using T = HelixTable;
    // clang-format off
    static const TableSpec table = Table<T>("rod.NAME.helix", "")
        .key("centre", &T::centre, "A point of the axis.")
            .unit("length").required()
        .key("axis", &T::axis, "Its direction.")
            .unit("1").required()
        .key("from", &T::from, "Where the rod starts; its distance from the axis is the radius.")
            .unit("length").required()
        .key("turns", &T::turns, "About the axis from start to end, right-handed; any number but 0.")
            .unit("1").required()
        .key("pitch", &T::pitch, "Advance along the axis in each turn. The helix is left-handed if one of turns and "
             "pitch is negative.")
            .unit("length").required();
    // clang-format on
    return table;
}

const TableSpec& catenary_table() {
    using T = CatenaryTable;
    // clang-format off
    static const TableSpec table = Table<T>("rod.NAME.catenary", "")
        .key("from", &T::from, "Where the rod starts.")
            .unit("length").required()
        .key("to", &T::to, "Where it ends.")
            .unit("length").required()
        .key("length", &T::length, "Of the rod, free of stress.")
            .unit("length").above(0).required()
        .key("bed", &T::bed, "Whether what hangs below a horizontal [seabed] lies on it.")
            .otherwise("false");
    // clang-format on
    return table;
}

}  // namespace

const Table<CurveTable>& curve_keys() {
    using T = CurveTable;
    // clang-format off
    static const Table<T> table = Table<T>("rod.NAME", "")
        .key("line", &T::line, line_table(), "The centreline: straight.")
        .key("arc", &T::arc, arc_table(), "A circular arc: from, through and to; or centre, axis, from and angle.")
        .key("helix", &T::helix, helix_table(), "A circular helix.")
        .key("polyline", &T::polyline, "Straight pieces between points, meeting in rigid corners with a node each.")
            .unit("length")
        .key("spline", &T::spline,
             "The natural cubic spline through points, its parameter the length of the chords.")
            .unit("length")
        .key("catenary", &T::catenary, catenary_table(), "As a line hangs between two points, z up: with "
             "gravity along -z by the weights of its sections and of bodies and loads at its points, in still water, "
             "and stretched by them. A rod that starts so is straight and without twist where it is free of stress, "
             "if `rest` does not say otherwise.");
    // clang-format on
    return table;
}

namespace {

// Lengths relative to the coordinates that count as zero.
constexpr double zero_length = 1e-12;
// Sines of angles: three points on a line, a rod that turns back.
constexpr double zero_angle = 1e-10;
// How far the start of an arc may be off the plane of its centre, relative to its radius.
constexpr double off_plane = 1e-6;

using Piece = std::unique_ptr<Curve>;

double size_of(const Vec3& a, const Vec3& b) {
    return std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>());
}

bool are_same(const Vec3& a, const Vec3& b) { return (b - a).stableNorm() <= zero_length * size_of(a, b); }

Piece find_line(const LineTable& given, const BuildContext& context) {
    if (!are_same(given.from, given.to)) return std::make_unique<LineCurve>(given.from, given.to);
    context.add_fault(given, given.to, "the rod has no length; expected an end away from its start");
    return nullptr;
}

// The unit vector along the axis of an ArcTable or a HelixTable.
template <class Given>
std::optional<Vec3> find_axis(const Given& given, const BuildContext& context) {
    if (!given.axis.isZero(0.0)) return given.axis.stableNormalized();
    context.add_fault(given, given.axis, "expected a direction, found a vector of zero length");
    return std::nullopt;
}

// The start as seen from the axis through a centre; nullopt if it is on it.
std::optional<Vec3> find_radius(const TableHead& given,
                                const Vec3& from,
                                const Vec3& centre,
                                const Vec3& axis,
                                const BuildContext& context) {
    const Vec3 arm = from - centre;
    const Vec3 radius = arm - arm.dot(axis) * axis;
    if (radius.stableNorm() > zero_length * size_of(centre, from)) return radius;
    context.add_fault(given, from, "on the axis, so that the radius is zero; expected a point off it");
    return std::nullopt;
}

Piece find_helix(const HelixTable& given, const BuildContext& context) {
    const std::optional<Vec3> axis = find_axis(given, context);
    if (!axis) return nullptr;
    const std::optional<Vec3> radius = find_radius(given, given.from, given.centre, *axis, context);
    if (given.turns == 0.0) context.add_fault(given, given.turns, "expected a number other than 0");
    if (!radius || given.turns == 0.0) return nullptr;
    const double rise = given.pitch * std::abs(given.turns);
    return std::make_unique<HelixCurve>(
        HelixShape{given.from, *axis, *radius, 2.0 * M_PI * given.turns, rise});
}

Piece find_arc_about_centre(const ArcTable& given, const BuildContext& context) {
    const std::optional<Vec3> axis = find_axis(given, context);
    if (!axis) return nullptr;
    const std::optional<Vec3> radius = find_radius(given, given.from, *given.centre, *axis, context);
    if (given.angle == 0.0) context.add_fault(given, given.angle, "expected a number other than 0");
    if (!radius || given.angle == 0.0) return nullptr;
    const double height = (given.from - *given.centre).dot(*axis);
    if (std::abs(height) > off_plane * radius->norm()) {
        context.add_fault(
            given,
            given.from,
            fmt::format("{:.6g} off the plane through centre across axis; expected a point in it",
                        std::abs(height)));
        return nullptr;
    }
    return std::make_unique<HelixCurve>(HelixShape{given.from, *axis, *radius, given.angle, 0.0});
}

Piece find_arc_through(const ArcTable& given, const BuildContext& context) {
    const Vec3& from = given.from;
    const Vec3& through = *given.through;
    const Vec3& to = given.to;
    if (are_same(from, to)) {
        context.add_fault(given, to, "at the start; expected an end away from it, or centre, axis and angle");
        return nullptr;
    }
    const Vec3 a = through - from;
    const Vec3 b = to - from;
    const Vec3 normal = a.cross(b);
    if (normal.norm() <= zero_angle * a.norm() * b.norm() || are_same(through, to) ||
        are_same(from, through)) {
        context.add_fault(given, through, "on a line with from and to; expected a point off it");
        return nullptr;
    }
    // From `from` to the centre of the circle through the three points.
    const Vec3 to_centre = (b.squaredNorm() * normal.cross(a) + a.squaredNorm() * b.cross(normal)) /
                           (2.0 * normal.squaredNorm());
    const Vec3 axis = normal.normalized();
    const Vec3 radius = -to_centre;
    const Vec3 end = b - to_centre;
    double angle = std::atan2(axis.cross(radius).dot(end), radius.dot(end));
    if (angle < 0.0) angle += 2.0 * M_PI;
    return std::make_unique<HelixCurve>(HelixShape{from, axis, radius, angle, 0.0});
}

Piece find_arc(const ArcTable& given, const BuildContext& context) {
    return given.through ? find_arc_through(given, context) : find_arc_about_centre(given, context);
}

// Whether neighbours are apart, by more than points of a rod are.
bool are_apart(const std::vector<CheckedVector>& points, const BuildContext& context) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += (points[i].value - points[i - 1].value).stableNorm();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double chord = (points[i].value - points[i - 1].value).stableNorm();
        if (chord > 4.0 * same_fraction * length && !are_same(points[i].value, points[i - 1].value)) continue;
        context.faults.add(points[i].place, points[i].path, "the same point as the one before");
        return false;
    }
    return true;
}

// The section that a rod has everywhere; nullptr if there is none.
const Section* find_section_everywhere(const std::optional<TableName>& name, const BuildContext& context) {
    if (!name) return nullptr;
    const auto& sections = context.model.sections;
    const auto found = std::ranges::find(sections, name->word, &Section::name);
    return found == sections.end() ? nullptr : &*found;
}

Piece find_catenary(const CatenaryTable& given,
                    const std::optional<TableName>& section,
                    const BuildContext& context) {
    const HungLineEnds ends{.from = given.from,
                            .to = given.to,
                            .length = given.length,
                            .bed = find_line_bed(given, find_section_everywhere(section, context), context)};
    try {
        return std::make_unique<HungLine>(ends);
    } catch (const std::invalid_argument& error) {
        context.add_fault(given, given.length, error.what());
        return nullptr;
    }
}

std::vector<Piece> find_polyline(const std::vector<CheckedVector>& points, const BuildContext& context) {
    if (!are_apart(points, context)) return {};
    std::vector<Piece> pieces;
    for (std::size_t i = 1; i < points.size(); ++i) {
        pieces.push_back(std::make_unique<LineCurve>(points[i - 1].value, points[i].value));
        if (i < 2) continue;
        const Vec3 before = pieces[i - 2]->tangent(0.0);
        if ((before + pieces[i - 1]->tangent(0.0)).norm() > zero_angle) continue;
        context.faults.add(
            points[i].place, points[i].path, "goes straight back; expected a corner below 180°");
        return {};
    }
    return pieces;
}

Piece find_spline(const std::vector<CheckedVector>& points, const BuildContext& context) {
    if (!are_apart(points, context)) return nullptr;
    std::vector<Vec3> places;
    for (const CheckedVector& point : points) places.push_back(point.value);
    const std::vector<Cubic> cubics = compute_natural_spline(places);
    const std::optional<double> fold = find_fold(cubics);
    if (!fold) return std::make_unique<PolynomialCurve>(cubics);
    const std::size_t after = std::min(static_cast<std::size_t>(*fold) + 1, points.size() - 1);
    context.faults.add(
        points[after].place,
        points[after].path,
        "the spline turns back on itself before this point; expected points along a smooth curve");
    return nullptr;
}

}  // namespace

std::optional<Centreline> find_centreline(const CurveTable& curve,
                                          const BuildContext& context,
                                          const std::optional<TableName>& section) {
    std::vector<Piece> pieces;
    if (curve.polyline) {
        pieces = find_polyline(*curve.polyline, context);
    } else if (curve.line) {
        pieces.push_back(find_line(*curve.line, context));
    } else if (curve.arc) {
        pieces.push_back(find_arc(*curve.arc, context));
    } else if (curve.helix) {
        pieces.push_back(find_helix(*curve.helix, context));
    } else if (curve.catenary) {
        pieces.push_back(find_catenary(*curve.catenary, section, context));
    } else {
        pieces.push_back(find_spline(*curve.spline, context));
    }
    if (pieces.empty() || pieces.front() == nullptr) return std::nullopt;
    return Centreline(std::move(pieces));
}

}  // namespace gxrod
