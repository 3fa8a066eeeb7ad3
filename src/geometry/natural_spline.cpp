#include "geometry/natural_spline.hpp"

namespace gxrod {
namespace {

// Second derivatives at the points, 0 at both ends: for each inner point i, with h the chords,
// h_{i-1} m_{i-1} + 2 (h_{i-1} + h_i) m_i + h_i m_{i+1} = 6 (d_i − d_{i-1}), d the divided differences.
// By elimination and back substitution, without pivoting, since the rows are diagonally dominant.
std::vector<Vec3> compute_second_derivatives(std::span<const Vec3> points, const std::vector<double>& chord) {
    const std::size_t count = points.size();
    std::vector<Vec3> second(count, Vec3::Zero());
    std::vector<double> diagonal(count, 1.0);
    const auto difference = [&](std::size_t i) -> Vec3 { return (points[i + 1] - points[i]) / chord[i]; };
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const double factor = i > 1 ? chord[i - 1] / diagonal[i - 1] : 0.0;
        diagonal[i] = 2.0 * (chord[i - 1] + chord[i]) - factor * chord[i - 1];
        second[i] = 6.0 * (difference(i) - difference(i - 1)) - factor * second[i - 1];
    }
    for (std::size_t i = count - 2; i >= 1 && i < count; --i) {
        const Vec3 next = i + 2 < count ? second[i + 1] : Vec3::Zero();
        second[i] = (second[i] - chord[i] * next) / diagonal[i];
    }
    return second;
}

}  // namespace

std::vector<Cubic> compute_natural_spline(std::span<const Vec3> points) {
    std::vector<double> chord;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) chord.push_back((points[i + 1] - points[i]).norm());
    const std::vector<Vec3> m = compute_second_derivatives(points, chord);
    std::vector<Cubic> cubics;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double square = chord[i] * chord[i];
        cubics.push_back({{points[i],
                           points[i + 1] - points[i] - square / 6.0 * (2.0 * m[i] + m[i + 1]),
                           square / 2.0 * m[i],
                           square / 6.0 * (m[i + 1] - m[i])}});
    }
    return cubics;
}

}  // namespace gxrod
