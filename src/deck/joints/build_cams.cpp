#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "deck/joints/ends.hpp"
#include "deck/joints/joint_table.hpp"
#include "deck/joints/joints.hpp"
#include "machine/file_error.hpp"
#include "machine/printable.hpp"
#include "rotation/vector_text.hpp"

// The curves of cams, joints of type "cam".
namespace gxrod {
namespace {

using CamPoints = std::vector<PlaneCurve::Point>;

// By so much of the model's size the roller may be off the curve at t = 0: the rounding of numbers in a deck.
constexpr double off_curve = 1e-6;
// By so much of its radius a curve by angle may be open after a whole turn.
constexpr double open_turn = 1e-9;
// By so much of that tolerance numbers of messages are zero.
constexpr double round_off = 1e-6;
// Angles at which the radius of a curve is evaluated.
constexpr int angle_count = 720;
// More points than any curve needs, whose crossings are looked for pair by pair.
constexpr std::size_t most_points = 10'000;
constexpr double whole_angle = 2.0 * std::numbers::pi;

CamPoints read_cam_points(std::string_view bytes, const std::string& file) {
    CamPoints points;
    for (const CsvRow& row : read_file_table(bytes, file).rows) {
        const auto refuse = [&](const std::string& message) {
            throw FileError(fmt::format("{}:{}", file, row.line), message);
        };
        if (row.fields.size() != 2) refuse(fmt::format("expected 2 columns, found {}", row.fields.size()));
        std::array<double, 2> numbers{};
        for (std::size_t i = 0; i < 2; ++i) {
            const std::optional<double> value = read_finite(row.fields[i]);
            if (!value) refuse(fmt::format("expected a finite number, found \"{}\"", shorten(row.fields[i])));
            numbers[i] = *value;
        }
        points.emplace_back(numbers[0], numbers[1]);
    }
    return points;
}

std::optional<CamPoints> follow_radius(const CamCurveTable& given, const BuildContext& context) {
    const auto& radius = given.radius->expression.function;
    CamPoints points;
    for (int i = 0; i < angle_count; ++i) {
        const double angle = whole_angle * i / angle_count;
        const double at = radius(angle);
        if (!(at > 0.0)) {
            context.add_fault(
                given,
                given.radius,
                fmt::format("is {:.6g} at angle = {:.6g}; expected a radius greater than 0", at, angle));
            return std::nullopt;
        }
        points.emplace_back(at * std::cos(angle), at * std::sin(angle));
    }
    const double first = radius(0.0), last = radius(whole_angle);
    if (std::abs(last - first) <= open_turn * first) return points;
    context.add_fault(
        given,
        given.radius,
        fmt::format("is {:.9g} at angle = 0 and {:.9g} at 2*pi; expected a curve that closes", first, last));
    return std::nullopt;
}

// The points of the curve; nullopt with a fault.
std::optional<CamPoints> list_cam_points(const JointTable& given, const BuildContext& context) {
    const CamCurveTable& curve = *given.curve;
    if (curve.radius) {
        try {
            return follow_radius(curve, context);
        } catch (const EvaluationError& error) {
            context.add_evaluation_fault(curve.radius->place, curve.radius->path, error);
            return std::nullopt;
        }
    }
    if (curve.file) return context.cam_points.at(given.name);
    CamPoints points;
    for (const auto& [x, y] : curve.points->rows) points.emplace_back(x, y);
    return points;
}

// Adds a fault of the curve, at the key that gives it.
void add_curve_fault(const CamCurveTable& curve, const BuildContext& context, const std::string& message) {
    if (curve.radius) return context.add_fault(curve, curve.radius, message);
    if (curve.file) return context.add_fault(curve, curve.file, message);
    context.add_fault(curve, curve.points, message);
}

std::string spell_point(const PlaneCurve::Point& point) {
    return fmt::format("[{:.6g}, {:.6g}]", point.x(), point.y());
}

// The curve; nullptr with a fault of points that make none.
std::shared_ptr<const PlaneCurve> make_cam_curve(const JointTable& given, const BuildContext& context) {
    const CamCurveTable& table = *given.curve;
    if (table.radius && !table.closed) {
        context.add_fault(table, table.closed, "a curve by radius is closed; expected points of an open one");
        return nullptr;
    }
    std::optional<CamPoints> points = list_cam_points(given, context);
    if (!points) return nullptr;
    if (table.closed && points->size() > 1 && points->front() == points->back()) points->pop_back();
    if (points->size() < PlaneCurve::fewest_points || points->size() > most_points) {
        add_curve_fault(table,
                        context,
                        fmt::format("expected {} to {} points, found {}",
                                    PlaneCurve::fewest_points,
                                    most_points,
                                    points->size()));
        return nullptr;
    }
    const auto same = std::adjacent_find(points->begin(), points->end());
    if (same != points->end()) {
        add_curve_fault(table,
                        context,
                        fmt::format("points {} and {} are both {}; expected neighbours apart",
                                    same - points->begin() + 1,
                                    same - points->begin() + 2,
                                    spell_point(*same)));
        return nullptr;
    }
    auto curve = std::make_shared<const PlaneCurve>(std::move(*points), table.closed);
    const std::optional<PlaneCurve::Place> crossing = curve->find_crossing();
    if (!crossing) return curve;
    add_curve_fault(table,
                    context,
                    fmt::format("the curve crosses itself near {}; expected one without crossings",
                                spell_point(crossing->point)));
    return nullptr;
}

// Adds a fault of a roller that would touch the curve at two places.
bool roller_fits(const JointTable& given, const JointCam& cam, const BuildContext& context) {
    const std::optional<PlaneCurve::Place> tight = cam.curve->find_tight_place(cam.roller, cam.side);
    if (!tight) return true;
    const double hollow = -cam.side * tight->curvature;
    const std::string reason =
        hollow * cam.roller >= 1.0
            ? fmt::format("the curve is hollow there with a radius of {:.6g}", 1.0 / hollow)
            : "it would touch the curve at another place too";
    context.add_fault(given,
                      given.roller,
                      fmt::format("the roller does not fit on the curve near {}: {}; expected a smaller "
                                  "roller, or a smoother curve",
                                  spell_point(tight->point),
                                  reason));
    return false;
}

}  // namespace

std::map<std::string, std::vector<PlaneCurve::Point>> read_cam_files(const CheckedTable& deck,
                                                                     const TableFiles& files,
                                                                     FaultList& faults,
                                                                     std::vector<MeshRecord>& records) {
    std::map<std::string, CamPoints> all;
    for (const JointTable& joint : tables_of<JointTable>(deck, joint_table())) {
        if (!joint.curve || !joint.curve->file) continue;
        const CamCurveTable& curve = *joint.curve;
        try {
            const std::string bytes = files.read(*curve.file);
            all.emplace(joint.name, read_cam_points(bytes, *curve.file));
            keep_file(*curve.file, bytes, records);
        } catch (const FileError& error) {
            faults.add(curve.place_of(&curve.file), curve.path_of(&curve.file), error.what());
        }
    }
    return all;
}

bool set_cam(const JointTable& given, double size, Joint& joint, const BuildContext& context) {
    JointCam cam{
        .curve = make_cam_curve(given, context), .roller = given.roller, .side = 1.0, .lifts = given.lifts};
    if (!cam.curve) return false;
    const Vec3 from_a = find_place(context.model, joint.b.anchor) - find_place(context.model, joint.a.anchor);
    const PlaneCurve::Point point(joint.a.axes.col(1).dot(from_a), joint.a.axes.col(2).dot(from_a));
    const PlaneCurve::Place nearest = cam.curve->find_nearest(point);
    const PlaneCurve::Point right(nearest.tangent.y(), -nearest.tangent.x());
    const double to_right = right.dot(point - nearest.point);
    const double tolerance = off_curve * std::max(size, cam.curve->length());
    const bool is_left_outside = cam.curve->is_closed() && !cam.curve->is_counter_clockwise();
    cam.side =
        std::abs(to_right) <= tolerance ? (is_left_outside ? -1.0 : 1.0) : std::copysign(1.0, to_right);
    if (!roller_fits(given, cam, context)) return false;
    const double gap = cam.side * to_right - cam.roller;
    joint.cam = cam;
    if (cam.lifts && gap >= tolerance) return true;
    const Vec3 correction = -gap * cam.side * (joint.a.axes.rightCols<2>() * Eigen::Vector2d(right));
    if (std::abs(gap) > tolerance) {
        context.add_fault(
            given,
            given.roller,
            fmt::format(
                "B's point is {:.9g} from the curve at t = 0; expected the roller's radius, {:.9g}{}, as "
                "at_b = {} is",
                std::abs(to_right),
                cam.roller,
                cam.lifts ? ", or more" : "",
                in_brackets(
                    find_place(context.model, joint.b.anchor) + correction, 9, round_off * tolerance)));
        return false;
    }
    joint.b.anchor.arm += correction;
    return true;
}

}  // namespace gxrod
