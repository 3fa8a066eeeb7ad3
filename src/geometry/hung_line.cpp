#include "geometry/hung_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

constexpr int most_iterations = 200;
constexpr double round_off = 4e-15;  // of the difference of two lengths

// A line that rises from the bed by a height, a = the level tension over the weight.
struct Riser {
    double length;        // along the line, s
    double surplus;       // of it over the span x = a arsinh(s/a)
    double surplus_rate;  // by a: 2h/s − arsinh(s/a)
};
Riser raise(double height, double a) {
    if (height == 0.0) return {0.0, 0.0, 0.0};
    const double length = std::sqrt(height * (height + 2.0 * a));
    const double slope = length / a;
    const double tilt = slope / (2.0 + height / a);  // h/s, of √(1 + slope²) = 1 + h/a
    const double defect = slope - std::asinh(slope);
    return {length, a * defect, defect - slope * tilt * tilt};
}

std::string name(const Vec3& place) { return fmt::format("({}, {}, {})", place[0], place[1], place[2]); }

}  // namespace

HungLine::HungLine(const HungLineEnds& ends)
    : from_(ends.from), to_(ends.to), level_(Vec3::UnitX()), length_(ends.length) {
    const Vec3 between = to_ - from_;
    const double distance = between.stableNorm();
    const double rise = between[2];
    span_ = std::hypot(between[0], between[1]);
    if (ends.bed && std::min(from_[2], to_[2]) < *ends.bed) {
        throw std::invalid_argument(fmt::format(
            "an end of the line, {} or {}, lies below the bed, z = {}", name(from_), name(to_), *ends.bed));
    }
    if (!(length_ >= distance * (1.0 - round_off)) || distance == 0.0) {
        throw std::invalid_argument(fmt::format(
            "the line's length, {}, is less than the distance of its ends, {}", length_, distance));
    }
    if (span_ > 0.0) level_ = Vec3(between[0], between[1], 0.0) / span_;
    if (length_ <= distance * (1.0 + round_off)) {
        is_straight_ = true;
        straight_angle_ = std::atan2(rise, span_);
        return;
    }
    if (span_ == 0.0) {
        throw std::invalid_argument(
            fmt::format("the ends of the line are above each other, and its length, {}, is not their "
                        "distance, {}: it would hang "
                        "double",
                        length_,
                        distance));
    }
    hang_freely(rise);
    if (ends.bed && finds_bed(*ends.bed - from_[2])) lay_on_bed(*ends.bed);
}

bool HungLine::finds_bed(double bed_rise) const {
    if (catenary_.slope >= 0.0 || catenary_.slope_at(length_) <= 0.0) return false;
    return catenary_.point_at(-catenary_.slope / catenary_.rate).z < bed_rise;
}

// With m half the sum of the arsinh of both end slopes: rise/length = tanh m, and (length² − rise²)/span² =
// (sinh x / x)², x half their difference.
void HungLine::hang_freely(double rise) {
    const double distance = std::hypot(span_, rise);
    const double surplus = (length_ - distance) / span_ * ((length_ + distance) / span_);
    const double x = find_catenary_argument(0.5 * std::log1p(surplus));
    catenary_ = {std::sinh(std::atanh(rise / length_) - x), 2.0 * x / span_};
}

// The lengths that rise from the bed exceed their spans by what the line's exceeds its own.
void HungLine::lay_on_bed(double bed) {
    const double bed_below_from = from_[2] - bed, bed_below_to = to_[2] - bed;
    bed_rise_ = -bed_below_from;
    const double heights = bed_below_from + bed_below_to;
    const double surplus = length_ - span_;
    if (surplus >= heights) {
        throw std::invalid_argument(fmt::format(
            "the line's length, {}, is more than its upright parts and the way on the bed between them, "
            "{}: it would lie there loosely",
            length_,
            span_ + heights));
    }
    const auto excess = [&](double a) {
        const Riser first = raise(bed_below_from, a), last = raise(bed_below_to, a);
        return std::pair(first.surplus + last.surplus - surplus, first.surplus_rate + last.surplus_rate);
    };
    // The excess falls as the tension grows; of nearly straight lines it is √(2h³/a)/3, which gives a start.
    double low = 0.0, high = std::numeric_limits<double>::infinity();
    double a = 0.2222 * heights * (heights / surplus) * (heights / surplus);
    for (int i = 0; i < most_iterations; ++i) {
        const auto [value, rate] = excess(a);
        (value > 0.0 ? low : high) = a;
        double next = a - value / rate;
        if (!(next > low && next < high)) next = std::isinf(high) ? 4.0 * a : 0.5 * (low + high);
        const bool is_found = std::abs(next - a) <= 2e-16 * a;
        a = next;
        if (is_found) break;
    }
    const Riser first = raise(bed_below_from, a), last = raise(bed_below_to, a);
    catenary_ = {0.0, 1.0 / a};
    on_bed_ = OnBed{first.length, length_ - last.length};
    meets_at_ = first.length - first.surplus;
    leaves_at_ = span_ - (last.length - last.surplus);
}

double HungLine::level_tension() const {
    return is_straight_ ? std::numeric_limits<double>::infinity() : 1.0 / catenary_.rate;
}

double HungLine::angle(double s) const {
    if (is_straight_) return straight_angle_;
    if (!on_bed_) return std::atan(catenary_.slope_at(s));
    if (s < on_bed_->from) return std::atan(catenary_.slope_at(s - on_bed_->from));
    return s > on_bed_->to ? std::atan(catenary_.slope_at(s - on_bed_->to)) : 0.0;
}

Catenary::Point HungLine::point_in_plane(double s) const {
    if (!on_bed_) return catenary_.point_at(s);
    if (s >= on_bed_->from && s <= on_bed_->to) return {meets_at_ + s - on_bed_->from, bed_rise_};
    const bool is_first = s < on_bed_->from;
    const Catenary::Point point = catenary_.point_at(s - (is_first ? on_bed_->from : on_bed_->to));
    return {(is_first ? meets_at_ : leaves_at_) + point.x, bed_rise_ + point.z};
}

Vec3 HungLine::position(double s) const {
    if (s <= 0.0) return from_;
    if (s >= length_) return to_;
    if (is_straight_) return from_ + s / length_ * (to_ - from_);
    const Catenary::Point point = point_in_plane(s);
    return from_ + point.x * level_ + point.z * Vec3::UnitZ();
}

Vec3 HungLine::tangent(double s) const {
    if (is_straight_) return (to_ - from_).stableNormalized();
    const double at = angle(s);
    return std::cos(at) * level_ + std::sin(at) * Vec3::UnitZ();
}

Quat HungLine::transport(double s) const { return exp_quaternion(turn(s) * level_.cross(Vec3::UnitZ())); }

double HungLine::turn(double s) const { return angle(s) - angle(0.0); }

}  // namespace gxrod
