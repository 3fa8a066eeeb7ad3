#include "laws/shape_fibres.hpp"

#include <cmath>

#include "numerics/gauss_legendre.hpp"

namespace gxrod {
namespace {

// Gauss points of r² with equal angles, of which every other ring is turned by half of one.
template <int Rings>
std::vector<Fibre> make_rings(double outer, double inner, int sectors) {
    std::vector<Fibre> fibres;
    const double area = M_PI * (outer - inner) * (outer + inner);
    int ring = 0;
    for (const QuadraturePoint& point : compute_gauss_rule<Rings>()) {
        const double share = 0.5 * (1.0 + point.xi);
        const double radius = std::sqrt(std::lerp(inner * inner, outer * outer, share));
        for (int i = 0; i < sectors; ++i) {
            const double angle = 2.0 * M_PI * (i + 0.5 * (ring % 2)) / sectors;
            fibres.push_back(
                {radius * std::cos(angle), radius * std::sin(angle), 0.5 * point.weight * area / sectors});
        }
        ++ring;
    }
    return fibres;
}

// Two Gauss points in each of half as many equal cells.
std::vector<double> place_along(double side, int count) {
    std::vector<double> places;
    const double cell = 2.0 * side / count;
    for (int i = 0; i < count / 2; ++i) {
        const double middle = (i + 0.5) * cell - 0.5 * side;
        for (const double sign : {-1.0, 1.0}) places.push_back(middle + sign * 0.5 * cell / std::sqrt(3.0));
    }
    return places;
}

}  // namespace

std::vector<Fibre> make_tube_fibres(double outer, double inner) {
    constexpr double thin = 0.7;
    return inner < thin * outer ? make_rings<12>(outer, inner, 48) : make_rings<4>(outer, inner, 48);
}

std::vector<Fibre> make_rectangle_fibres(double width, double height) {
    constexpr double nearly_square = 0.7;
    constexpr int across = 24;
    const double ratio = std::min(width, height) / std::max(width, height);
    const int along = ratio > nearly_square ? 24 : 32;
    std::vector<Fibre> fibres;
    for (const double y : place_along(width, width < height ? across : along)) {
        for (const double z : place_along(height, width < height ? along : across))
            fibres.push_back({y, z, width * height / (along * across)});
    }
    return fibres;
}

}  // namespace gxrod
