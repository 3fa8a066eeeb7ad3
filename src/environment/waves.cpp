#include "environment/waves.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gxrod {

namespace {

// e^{−40} is 4e-18: trains of less than that of their motion at still water are left out.
constexpr double no_motion = 40.0;
// e^{−2·20} is 4e-18 too: the bed is not felt.
constexpr double no_bed = 20.0;

using PartialSums = std::array<double, most_wave_sums * wave_group>;

double total(const PartialSums& sums, std::size_t k) {
    const double* const part = sums.data() + k * wave_group;
    return (part[0] + part[1]) + (part[2] + part[3]);
}

// Of a field without divergence and rotation, from the components in the plane, and of z by x and y.
Mat3 make_gradient(double xx, double xy, double yy, double zx, double zy) {
    Mat3 gradient;
    gradient << xx, xy, zx, xy, yy, zy, zx, zy, -(xx + yy);
    return gradient;
}

FlowAt expand_along(const PartialSums& sums, double x, double y) {
    const auto sum = [&](std::size_t k) { return total(sums, k); };
    const auto gradient = [&](double level, double upright) {
        return make_gradient(level * x * x, level * x * y, level * y * y, upright * x, upright * y);
    };
    return {{sum(0) * x, sum(0) * y, sum(1)},
            {sum(2) * x, sum(2) * y, -sum(3)},
            gradient(-sum(4), sum(5)),
            gradient(sum(6), sum(7))};
}

FlowAt expand_in_plane(const PartialSums& sums) {
    const auto sum = [&](std::size_t k) { return total(sums, k); };
    return {{sum(0), sum(1), sum(2)},
            {sum(3), sum(4), -sum(5)},
            make_gradient(-sum(6), -sum(7), -sum(8), sum(9), sum(10)),
            make_gradient(sum(11), sum(12), sum(13), sum(14), sum(15))};
}

// The height of the formula varies with the place.
void chain(Mat3& gradient, const Vec3& height_gradient) {
    const Vec3 by_height = gradient.col(2);
    gradient.col(2).setZero();
    gradient += by_height * height_gradient.transpose();
}

}  // namespace

Waves::Waves(const Water& water, const WaveKernels& kernels)
    : stretching_(water.stretching),
      depth_(water.depth),
      ramp_start_(water.ramp_start),
      ramp_length_(water.ramp),
      trains_(water.waves.size()) {
    std::vector<WaveTrain> trains = water.waves;
    std::stable_sort(
        trains.begin(), trains.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
    for (const WaveTrain& train : trains) {
        is_long_crested_ = is_long_crested_ && train.direction == trains.front().direction;
        add_row(train);
    }
    pad_rows();
    kernels_ = is_long_crested_ ? kernels.along : kernels.in_plane;
}

void Waves::add_row(const WaveTrain& train) {
    const double twice_depth = depth_ ? 2.0 * train.number * *depth_ : 0.0;
    const double echo = depth_ ? std::exp(-twice_depth) : 0.0;
    const double without_echo = depth_ ? -std::expm1(-twice_depth) : 1.0;
    const double flow = train.amplitude * train.frequency / without_echo;
    rows_.number.push_back(train.number);
    rows_.frequency.push_back(train.frequency);
    rows_.phase.push_back(train.phase);
    rows_.cosine.push_back(std::cos(train.direction));
    rows_.sine.push_back(std::sin(train.direction));
    rows_.amplitude.push_back(train.amplitude);
    rows_.flow.push_back(flow);
    rows_.echo.push_back(echo);
    rows_.flow_slope.push_back(train.number * flow);
    rows_.echo_slope.push_back(-echo);
}

void Waves::pad_rows() {
    const std::size_t padded = (trains_ + wave_group - 1) / wave_group * wave_group;
    for (auto* const row : {&rows_.number,
                            &rows_.frequency,
                            &rows_.phase,
                            &rows_.lag,
                            &rows_.cosine,
                            &rows_.sine,
                            &rows_.amplitude,
                            &rows_.flow,
                            &rows_.echo,
                            &rows_.flow_slope,
                            &rows_.echo_slope}) {
        row->resize(padded, 0.0);
    }
}

void Waves::move_to(double time) {
    for (std::size_t i = 0; i < trains_; ++i) rows_.lag[i] = rows_.frequency[i] * time - rows_.phase[i];
    ramp_ = 1.0;
    ramp_rate_ = 0.0;
    if (!(ramp_length_ > 0.0)) return;
    const double q = std::clamp((time - ramp_start_) / ramp_length_, 0.0, 1.0);
    ramp_ = q * q * q * (10.0 - 15.0 * q + 6.0 * q * q);
    ramp_rate_ = 30.0 * q * q * (1.0 - q) * (1.0 - q) / ramp_length_;
}

Waves::At Waves::at(const Vec3& place) const {
    thread_local std::vector<double> phases;
    phases.resize(2 * rows_.number.size());
    const WaveSurface surface = find_surface(place, phases.data());
    const FormulaHeight height = find_formula_height(stretching_, place[2], depth_, surface);
    const bool is_continued = stretching_ == Stretching::extrapolate && height.z > 0.0;
    FlowAt flow = is_continued ? continue_along_tangent(height.z, phases.data())
                               : sum_flow(height.z, phases.data(), false);
    chain(flow.velocity_gradient, height.gradient);
    chain(flow.acceleration_gradient, height.gradient);
    return {surface,
            {ramp_ * flow.velocity,
             ramp_ * flow.acceleration + ramp_rate_ * flow.velocity,
             ramp_ * flow.velocity_gradient,
             ramp_ * flow.acceleration_gradient + ramp_rate_ * flow.velocity_gradient}};
}

WaveSurface Waves::find_surface(const Vec3& place, double* phases) const {
    const double x = rows_.cosine[0], y = rows_.sine[0];
    const std::array<double, 2> in_plane{place[0], place[1]}, along{x * place[0] + y * place[1], 0.0};
    PartialSums sums;
    kernels_.sum_surface({rows_.number.data(),
                          rows_.frequency.data(),
                          rows_.lag.data(),
                          rows_.cosine.data(),
                          rows_.sine.data(),
                          rows_.amplitude.data(),
                          rows_.flow.data(),
                          rows_.echo.data()},
                         rows_.number.size(),
                         is_long_crested_ ? along.data() : in_plane.data(),
                         phases,
                         sums.data());
    const double slope = -ramp_ * total(sums, 1);
    const Vec3 slopes =
        is_long_crested_ ? Vec3(slope * x, slope * y, 0.0) : Vec3(slope, -ramp_ * total(sums, 2), 0.0);
    return {ramp_ * total(sums, 0), slopes};
}

// Where the group ends in which wave numbers exceed this one.
std::size_t Waves::end_of_group(double number) const {
    const auto begin = rows_.number.begin();
    const auto past = std::upper_bound(begin, begin + static_cast<std::ptrdiff_t>(trains_), number);
    const auto index = static_cast<std::size_t>(past - begin);
    return (index + wave_group - 1) / wave_group * wave_group;
}

FlowAt Waves::sum_flow(double z, const double* phases, bool by_height) const {
    const WaveRows rows{rows_.number.data(),
                        rows_.frequency.data(),
                        rows_.lag.data(),
                        rows_.cosine.data(),
                        rows_.sine.data(),
                        rows_.amplitude.data(),
                        by_height ? rows_.flow_slope.data() : rows_.flow.data(),
                        by_height ? rows_.echo_slope.data() : rows_.echo.data()};
    const std::size_t end = z < 0.0 ? end_of_group(no_motion / -z) : rows_.number.size();
    std::size_t deep = 0;
    if (depth_) deep = z > -*depth_ ? std::min(end, end_of_group(no_bed / (z + *depth_))) : end;
    PartialSums sums{};
    kernels_.add_flow(rows, {0, deep}, z, phases, sums.data());
    kernels_.add_deep_flow(rows, {deep, end}, z, phases, sums.data());
    return is_long_crested_ ? expand_along(sums, rows_.cosine[0], rows_.sine[0]) : expand_in_plane(sums);
}

// From still water on along the tangent there. The gradient has the derivative by the height in its last
// column.
FlowAt Waves::continue_along_tangent(double z, const double* phases) const {
    FlowAt flow = sum_flow(0.0, phases, false);
    const FlowAt slope = sum_flow(0.0, phases, true);
    flow.velocity += z * slope.velocity;
    flow.acceleration += z * slope.acceleration;
    flow.velocity_gradient.leftCols<2>() += z * slope.velocity_gradient.leftCols<2>();
    flow.acceleration_gradient.leftCols<2>() += z * slope.acceleration_gradient.leftCols<2>();
    flow.velocity_gradient.col(2) = slope.velocity;
    flow.acceleration_gradient.col(2) = slope.acceleration;
    return flow;
}

}  // namespace gxrod
