#include "model/sections/section_frame.hpp"

#include <cmath>
#include <limits>

#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// R, from the frame's axes to the section's.
Mat3 axes_of(const SectionFrame& frame) {
    const double c = std::cos(frame.turn);
    const double s = std::sin(frame.turn);
    Mat3 axes;
    axes << 1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c;
    return axes;
}

// Symmetric to the last bit, and without the round-off of sin π, which would couple what is not coupled.
Mat6 cleaned(const Mat6& matrix) {
    constexpr double round_off = 8.0 * std::numeric_limits<double>::epsilon();
    Mat6 clean = 0.5 * (matrix + matrix.transpose());
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            const double scale = std::sqrt(matrix(i, i)) * std::sqrt(matrix(j, j));
            if (i != j && std::abs(clean(i, j)) <= round_off * scale) clean(i, j) = 0.0;
        }
    }
    return clean;
}

}  // namespace

Mat6 compute_strain_map(const SectionFrame& frame) {
    const Mat3 to_frame = axes_of(frame).transpose();
    Mat6 T = Mat6::Zero();
    T.topLeftCorner<3, 3>() = to_frame;
    T.topRightCorner<3, 3>() = -to_frame * spin({0.0, frame.y, frame.z});
    T.bottomRightCorner<3, 3>() = to_frame;
    return T;
}

Mat6 move_from(const SectionFrame& frame, const Mat6& matrix) {
    if (frame.is_trivial()) return matrix;
    const Mat6 T = compute_strain_map(frame);
    return cleaned(T.transpose() * matrix * T);
}

Mat6 move_to(const SectionFrame& frame, const Mat6& matrix) {
    // The section's axes as the frame sees them.
    const double c = std::cos(frame.turn);
    const double s = std::sin(frame.turn);
    return move_from({-c * frame.y - s * frame.z, s * frame.y - c * frame.z, -frame.turn}, matrix);
}

}  // namespace gxrod
