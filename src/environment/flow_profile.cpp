#include "environment/flow_profile.hpp"

#include <algorithm>

namespace gxrod {
namespace {

// A number of each row at a height, and how it changes with the height.
struct ColumnAt {
    double value = 0.0, slope = 0.0;
};

ColumnAt interpolate_column(const SpeedProfile& profile, std::size_t column, double height) {
    const std::vector<double>& heights = profile.heights;
    const auto at = [&](std::size_t row) { return profile.speeds[row * width_of(profile) + column]; };
    if (height <= heights.front()) return {at(0), 0.0};
    if (height >= heights.back()) return {at(heights.size() - 1), 0.0};
    const auto above = std::upper_bound(heights.begin(), heights.end(), height);
    const auto i = static_cast<std::size_t>(above - heights.begin());
    const double slope = (at(i) - at(i - 1)) / (heights[i] - heights[i - 1]);
    return {at(i - 1) + slope * (height - heights[i - 1]), slope};
}

Vec3 turn_about_z(const Vec3& direction, double turn) {
    return Eigen::AngleAxisd(turn, Vec3::UnitZ()) * direction;
}

}  // namespace

Vec3 velocity_at_row(const SpeedProfile& profile, std::size_t row) {
    const double* numbers = &profile.speeds[row * width_of(profile)];
    if (width_of(profile) == 3) return {numbers[0], numbers[1], numbers[2]};
    if (width_of(profile) == 1) return numbers[0] * profile.direction;
    return numbers[0] * turn_about_z(profile.direction, numbers[1]);
}

ProfileAt interpolate_turning(const SpeedProfile& profile, double height) {
    const auto column = [&](std::size_t number) { return interpolate_column(profile, number, height); };
    if (width_of(profile) == 3) {
        const ColumnAt x = column(0), y = column(1), z = column(2);
        return {{x.value, y.value, z.value}, {x.slope, y.slope, z.slope}};
    }
    const ColumnAt speed = column(0), turn = column(1);
    const Vec3 along = turn_about_z(profile.direction, turn.value);
    return {speed.value * along, speed.slope * along + speed.value * turn.slope * Vec3::UnitZ().cross(along)};
}

}  // namespace gxrod
