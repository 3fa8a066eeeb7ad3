#include "environment/current.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "environment/flow_profile.hpp"
#include "model/evaluation_error.hpp"

namespace gxrod {

namespace {

// Of central differences: the cube root of the spacing of numbers.
constexpr double difference = 6e-6;

struct Interpolated {
    double value, slope;
};

Interpolated interpolate(const SpeedProfile& profile, double height) {
    const std::vector<double>& heights = profile.heights;
    if (height <= heights.front()) return {profile.speeds.front(), 0.0};
    if (height >= heights.back()) return {profile.speeds.back(), 0.0};
    const auto above = std::upper_bound(heights.begin(), heights.end(), height);
    const auto i = static_cast<std::size_t>(above - heights.begin());
    const double slope = (profile.speeds[i] - profile.speeds[i - 1]) / (heights[i] - heights[i - 1]);
    return {profile.speeds[i - 1] + slope * (height - heights[i - 1]), slope};
}

// The derivative of a function by the time; on from 0 without times before it, for which a function need not
// have a value.
template <class Function>
auto differentiate(const Function& function, double time) {
    using Value = decltype(function(time));
    const double step = difference * std::max(1.0, std::abs(time));
    if (time >= 0.0 && time < step) {
        return Value((4.0 * function(time + step) - 3.0 * function(time) - function(time + 2.0 * step)) /
                     (2.0 * step));
    }
    return Value((function(time + step) - function(time - step)) / (2.0 * step));
}

}  // namespace

Current::Current(const Flow& flow, double length, std::string fluid)
    : flow_(&flow), step_(difference * length), fluid_(std::move(fluid)) {}

void Current::move_to(double time) {
    time_ = time;
    if (!flow_->profile) return;
    const TimeFunction& factor = flow_->profile->factor;
    factor_ = factor(time);
    factor_rate_ = factor.has_time() ? differentiate(factor, time) : 0.0;
    if (!std::isfinite(factor_) || !std::isfinite(factor_rate_)) {
        throw EvaluationError(fmt::format(
            "the factor of the velocity of {} or its rate is not finite at t = {}", fluid_, time));
    }
}

FlowAt Current::at(const Vec3& place, const FormulaHeight& height, bool gradients) const {
    FlowAt flow;
    if (flow_->profile) flow = find_profile(height);
    if (!flow_->field) return flow;
    const FlowAt field = find_field(place, gradients);
    return {flow.velocity + field.velocity,
            flow.acceleration + field.acceleration,
            flow.velocity_gradient + field.velocity_gradient,
            flow.acceleration_gradient};
}

FlowAt Current::find_profile(const FormulaHeight& height) const {
    const SpeedProfile& profile = *flow_->profile;
    if (width_of(profile) > 1) {
        const auto [velocity, by_height] = interpolate_turning(profile, height.z);
        const Mat3 changes = by_height * height.gradient.transpose();
        return {factor_ * velocity, factor_rate_ * velocity, factor_ * changes, factor_rate_ * changes};
    }
    const auto [speed, slope] = interpolate(profile, height.z);
    const Mat3 gradient = slope * profile.direction * height.gradient.transpose();
    return {factor_ * speed * profile.direction,
            factor_rate_ * speed * profile.direction,
            factor_ * gradient,
            factor_rate_ * gradient};
}

FlowAt Current::find_field(const Vec3& place, bool gradients) const {
    FlowAt flow;
    flow.velocity = evaluate_field(time_, place);
    flow.acceleration =
        differentiate([&](double time) -> Vec3 { return evaluate_field(time, place); }, time_);
    for (int j = 0; gradients && j < 3; ++j) {
        const Vec3 step = step_ * Vec3::Unit(j);
        flow.velocity_gradient.col(j) =
            (evaluate_field(time_, place + step) - evaluate_field(time_, place - step)) / (2.0 * step_);
    }
    return flow;
}

Vec3 Current::evaluate_field(double time, const Vec3& place) const {
    Vec3 velocity = flow_->field(time, place);
    if (velocity.allFinite()) return velocity;
    throw EvaluationError(fmt::format("the velocity of {} is not finite at ({}, {}, {}), t = {}",
                                      fluid_,
                                      place[0],
                                      place[1],
                                      place[2],
                                      time));
}

}  // namespace gxrod
