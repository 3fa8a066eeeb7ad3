#include "cross_section/outlines/outline_moments.hpp"

#include <Eigen/Geometry>

#include "numerics/gauss_legendre.hpp"

namespace gxrod {
namespace {

// ∫ of 1, y, z, z², y², y z over an area.
using AreaIntegrals = Eigen::Vector<double, 6>;

// Green's theorem at a point of the boundary: ∫ f dA = ∮ F dz or −∮ F dy with ∂F/∂y = f or ∂F/∂z = f.
AreaIntegrals integrand(const PlanePoint& at, const PlanePoint& along) {
    const double y = at.x(), z = at.y();
    const double dy = along.x(), dz = along.y();
    AreaIntegrals values;
    values << 0.5 * (y * dz - z * dy), y * y / 2.0 * dz, -z * z / 2.0 * dy, -z * z * z / 3.0 * dy,
        y * y * y / 3.0 * dz, y * y * z / 2.0 * dz;
    return values;
}

}  // namespace

OutlineMoments compute_moments(const Outline& outline) {
    // Exact for straight pieces, and to round-off for arcs up to half a circle.
    static const auto rule = compute_gauss_rule<16>();
    const PlanePoint origin = outline.outer.front().from;
    AreaIntegrals sum = AreaIntegrals::Zero();
    for (const OutlineLoop* loop : outline.loops()) {
        for (const OutlinePiece& piece : *loop) {
            const double length = piece.length();
            for (const auto& [xi, weight] : rule) {
                const double fraction = 0.5 * (1.0 + xi);
                const PlanePoint along = 0.5 * weight * length * piece.direction(fraction);
                sum += integrand(piece.at(fraction) - origin, along);
            }
        }
    }
    const double area = sum[0];
    const PlanePoint centroid(sum[1] / area, sum[2] / area);
    return {.area = area,
            .centroid = origin + centroid,
            .Iy = sum[3] - area * centroid.y() * centroid.y(),
            .Iz = sum[4] - area * centroid.x() * centroid.x(),
            .Iyz = sum[5] - area * centroid.x() * centroid.y()};
}

}  // namespace gxrod
