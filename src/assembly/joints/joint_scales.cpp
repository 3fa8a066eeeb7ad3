#include "assembly/joints/joint_scales.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

// The least scale of a joint, relative to the largest.
constexpr double least_scale = 1e-6;

}  // namespace

void DiagonalMean::add(int component, double value) {
    const int kind = component / 3 % 2;
    sums_[kind] += std::abs(value);
    ++counts_[kind];
}

JointScales DiagonalMean::mean() const {
    return {sums_[0] / std::max(counts_[0], 1), sums_[1] / std::max(counts_[1], 1)};
}

void bound_scales(double length, std::vector<JointScales>& scales) {
    JointScales largest;
    for (const JointScales& scale : scales)
        largest = {std::max(largest.length, scale.length), std::max(largest.turn, scale.turn)};
    const double square = length * length;
    // Where all of one kind are 0, each has what the other kind makes of it.
    const double length_part = largest.length == 0.0 ? 1.0 : least_scale;
    const double turn_part = largest.turn == 0.0 ? 1.0 : least_scale;
    if (largest.length == 0.0) largest.length = largest.turn / square;
    if (largest.turn == 0.0) largest.turn = largest.length * square;
    if (largest.length == 0.0) largest = {1.0, square};
    for (JointScales& scale : scales) {
        scale.length = std::max(scale.length, length_part * largest.length);
        scale.turn = std::max(scale.turn, turn_part * largest.turn);
    }
}

}  // namespace gxrod
