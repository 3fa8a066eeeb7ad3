#include "geometry/polynomial_curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "numerics/gauss_legendre.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Where a rule over the whole and one over each half agree to this, relative, the halves are right to
// round-off: halving divides the error of 12 points by 2^24.
constexpr double halves_suffice = 1e-9;
constexpr int most_halvings = 40;
// The samples of a cubic among which a fold is looked for.
constexpr int fold_samples = 128;
constexpr double no_slope = 1e-9;  // relative to the size of the cubic

// The 12-point rule on [0, 1], exact for polynomials of degree 23.
std::array<QuadraturePoint, 12> compute_unit_rule() {
    std::array<QuadraturePoint, 12> rule = compute_gauss_rule<12>();
    for (auto& [at, weight] : rule) {
        at = 0.5 * (1.0 + at);
        weight *= 0.5;
    }
    return rule;
}

const std::array<QuadraturePoint, 12> unit_rule = compute_unit_rule();

double compute_length(const Cubic& cubic, double u) {
    double length = 0.0;
    for (const auto& [at, weight] : unit_rule) length += weight * cubic.slope(u * at).norm();
    return u * length;
}

// The angle ψ by which carried axes turn about the tangent, from 0 to u, against axes that follow it by the
// smallest rotation from the tangent k at 0: dψ/du = k·(r′ × r″)/(r′·r′ (1 + k·t)).
double compute_carried_angle(const Cubic& cubic, const Vec3& k, double u) {
    double angle = 0.0;
    for (const auto& [at, weight] : unit_rule) {
        const Vec3 slope = cubic.slope(u * at);
        const double cosine = k.dot(slope.normalized());
        angle += weight * k.dot(slope.cross(cubic.bend(u * at))) / (slope.squaredNorm() * (1.0 + cosine));
    }
    return u * angle;
}

Quat compute_transport(const Cubic& cubic, double u) {
    const Vec3 k = cubic.slope(0.0).normalized();
    return smallest_rotation(k, cubic.slope(u).normalized()) *
           exp_quaternion(compute_carried_angle(cubic, k, u) * k);
}

// Between the tangents at 0 and u.
double compute_turn(const Cubic& cubic, double u) {
    const Vec3 first = cubic.slope(0.0);
    const Vec3 last = cubic.slope(u);
    return std::atan2(first.cross(last).norm(), first.dot(last));
}

// The part from u = first to first + width, by a u of its own.
Cubic part_of(const Cubic& cubic, double first, double width) {
    return {{cubic.position(first),
             width * cubic.slope(first),
             0.5 * width * width * cubic.bend(first),
             width * width * width * cubic.c[3]}};
}

bool turns_little(const Cubic& cubic) {
    constexpr double cosine = 0.8;
    const Vec3 k = cubic.slope(0.0).normalized();
    return k.dot(cubic.slope(0.5).normalized()) > cosine && k.dot(cubic.slope(1.0).normalized()) > cosine;
}

bool is_measured_by_halves(const Cubic& cubic, const Cubic& first, const Cubic& second) {
    if (!turns_little(cubic)) return false;
    const double length = compute_length(cubic, 1.0);
    const double halves = compute_length(first, 1.0) + compute_length(second, 1.0);
    const Quat both = compute_transport(second, 1.0) * compute_transport(first, 1.0);
    return std::abs(length - halves) <= halves_suffice * length &&
           both.angularDistance(compute_transport(cubic, 1.0)) <= halves_suffice;
}

}  // namespace

Cubic interpolate(std::span<const Vec3> points) {
    const auto& p = points;
    switch (points.size()) {
        case 2:
            return {{p[0], p[1] - p[0], Vec3::Zero(), Vec3::Zero()}};
        case 3:
            return {{p[0], 4.0 * p[1] - 3.0 * p[0] - p[2], 2.0 * (p[0] - 2.0 * p[1] + p[2]), Vec3::Zero()}};
        default:
            assert(points.size() == 4);
            return {{p[0],
                     0.5 * (-11.0 * p[0] + 18.0 * p[1] - 9.0 * p[2] + 2.0 * p[3]),
                     4.5 * (2.0 * p[0] - 5.0 * p[1] + 4.0 * p[2] - p[3]),
                     4.5 * (-p[0] + 3.0 * p[1] - 3.0 * p[2] + p[3])}};
    }
}

std::optional<double> find_fold(std::span<const Cubic> cubics) {
    for (std::size_t i = 0; i < cubics.size(); ++i) {
        const Cubic& cubic = cubics[i];
        double size = 0.0;
        for (const double u : {0.0, 0.5, 1.0}) size = std::max(size, cubic.slope(u).norm());
        Vec3 last = cubic.slope(0.0);
        for (int k = 0; k <= fold_samples; ++k) {
            const double u = static_cast<double>(k) / fold_samples;
            const Vec3 slope = cubic.slope(u);
            if (!(slope.norm() > no_slope * size) || slope.dot(last) <= 0.0) {
                return static_cast<double>(i) + u;
            }
            last = slope;
        }
    }
    return std::nullopt;
}

PolynomialCurve::PolynomialCurve(std::span<const Cubic> cubics) {
    for (std::size_t i = 0; i < cubics.size(); ++i) {
        add_segments(cubics[i], static_cast<double>(i), 1.0, 0);
    }
}

void PolynomialCurve::add_segments(const Cubic& cubic,
                                   double first_parameter,
                                   double parameter_width,
                                   int depth) {
    const double half = 0.5 * parameter_width;
    const Cubic first = part_of(cubic, 0.0, 0.5);
    const Cubic second = part_of(cubic, 0.5, 0.5);
    if (depth == most_halvings || is_measured_by_halves(cubic, first, second)) {
        add_segment(first, first_parameter, half);
        add_segment(second, first_parameter + half, half);
        return;
    }
    add_segments(first, first_parameter, half, depth + 1);
    add_segments(second, first_parameter + half, half, depth + 1);
}

void PolynomialCurve::add_segment(const Cubic& cubic, double first_parameter, double parameter_width) {
    const double length = compute_length(cubic, 1.0);
    segments_.push_back(
        {cubic, first_parameter, parameter_width, length_, length, end_transport_, end_turn_});
    length_ += length;
    end_turn_ += compute_turn(cubic, 1.0);
    end_transport_ = (compute_transport(cubic, 1.0) * end_transport_).normalized();
}

PolynomialCurve::Place PolynomialCurve::place_of(double s) const {
    const auto after =
        std::upper_bound(segments_.begin() + 1, segments_.end(), s, [](double at, const Segment& segment) {
            return at < segment.start;
        });
    const Segment& segment = *(after - 1);
    const double wanted = std::clamp(s - segment.start, 0.0, segment.length);
    if (wanted == segment.length) return {segment, 1.0};
    // Newton's method, kept between bounds that close in.
    double lower = 0.0;
    double upper = 1.0;
    double u = wanted / segment.length;
    for (int iteration = 0; iteration < 60; ++iteration) {
        const double excess = compute_length(segment.cubic, u) - wanted;
        (excess > 0.0 ? upper : lower) = u;
        const double next = u - excess / segment.cubic.slope(u).norm();
        const double step = std::abs(next - u);
        u = next >= lower && next <= upper ? next : 0.5 * (lower + upper);
        if (step <= 1e-16 || std::abs(excess) <= 1e-16 * segment.length) break;
    }
    return {segment, u};
}

Vec3 PolynomialCurve::position(double s) const {
    const Place place = place_of(s);
    return place.segment.cubic.position(place.u);
}

Vec3 PolynomialCurve::tangent(double s) const {
    const Place place = place_of(s);
    return place.segment.cubic.slope(place.u).normalized();
}

Quat PolynomialCurve::transport(double s) const {
    const Place place = place_of(s);
    return compute_transport(place.segment.cubic, place.u) * place.segment.transport;
}

double PolynomialCurve::turn(double s) const {
    const Place place = place_of(s);
    return place.segment.turn + compute_turn(place.segment.cubic, place.u);
}

double PolynomialCurve::arc_length_at(double parameter) const {
    const auto after =
        std::upper_bound(segments_.begin() + 1, segments_.end(), parameter, [](double at, const Segment& s) {
            return at < s.first_parameter;
        });
    const Segment& segment = *(after - 1);
    const double u = std::clamp((parameter - segment.first_parameter) / segment.parameter_width, 0.0, 1.0);
    return segment.start + compute_length(segment.cubic, u);
}

}  // namespace gxrod
