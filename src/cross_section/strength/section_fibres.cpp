#include "cross_section/strength/section_fibres.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace gxrod {
namespace {

constexpr int fibres_of_group = 4;
constexpr int least_groups = 8;  // of a material

// Coordinates are scaled so that the section has the same variance in all directions: thin strips are then
// cut across, too.
struct WeighedPoint {
    PlanePoint at;
    double area;
};

// Moments of points up to the second.
struct PointGroup {
    double area = 0.0;
    PlanePoint centre = PlanePoint::Zero();
    Eigen::Vector2d spread = Eigen::Vector2d::Zero();  // variances along the principal axes, rising
    Eigen::Matrix2d axes = Eigen::Matrix2d::Identity();

    explicit PointGroup(std::span<const WeighedPoint> points) {
        for (const WeighedPoint& point : points) {
            area += point.area;
            centre += point.area * point.at;
        }
        centre /= area;
        Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
        for (const WeighedPoint& point : points)
            moments += point.area * (point.at - centre) * (point.at - centre).transpose();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(moments / area);
        spread = principal.eigenvalues().cwiseMax(0.0);
        axes = principal.eigenvectors();
    }
};

// Four points at one deviation to both sides along both principal axes, as Gauss points of a rectangle.
void add_fibres(const PointGroup& group, std::vector<WeighedPoint>& fibres) {
    for (const double along : {-1.0, 1.0}) {
        for (const double across : {-1.0, 1.0}) {
            const Eigen::Vector2d offset(across * std::sqrt(group.spread[0]),
                                         along * std::sqrt(group.spread[1]));
            fibres.push_back({group.centre + group.axes * offset, group.area / fibres_of_group});
        }
    }
}

// Cuts points across their longest extent into halves of equal area, `cuts` times. A point on a cut belongs
// to both halves in parts.
void add_groups(std::vector<WeighedPoint> points, int cuts, std::vector<WeighedPoint>& fibres) {
    const PointGroup group(points);
    if (cuts == 0 || points.size() == 1) return add_fibres(group, fibres);
    const Eigen::Vector2d axis = group.axes.col(1);
    std::ranges::sort(points, {}, [&](const WeighedPoint& point) { return axis.dot(point.at); });
    std::vector<WeighedPoint> lower, upper;
    double area = 0.0;
    for (const WeighedPoint& point : points) {
        const double below = std::clamp(0.5 * group.area - area, 0.0, point.area);
        if (below > 0.0) lower.push_back({point.at, below});
        if (below < point.area) upper.push_back({point.at, point.area - below});
        area += point.area;
    }
    add_groups(std::move(lower), cuts - 1, fibres);
    add_groups(std::move(upper), cuts - 1, fibres);
}

// The points of each material.
std::map<int, std::vector<WeighedPoint>> list_points(const SectionQuadrature& quadrature) {
    std::map<int, std::vector<WeighedPoint>> points;
    for (const CellPoints& cell : quadrature.cells()) {
        const SectionLayer& layer = quadrature.mesh().layers[static_cast<std::size_t>(cell.cell->layer)];
        for (std::size_t q = 0; q < cell.at.size(); ++q)
            points[layer.material].push_back({cell.at[q], cell.weights[q]});
    }
    return points;
}

}  // namespace

std::vector<SectionFibre> make_section_fibres(const SectionQuadrature& quadrature,
                                              const FibreSettings& settings) {
    std::map<int, std::vector<WeighedPoint>> points_of = list_points(quadrature);
    std::vector<WeighedPoint> all;
    for (const auto& [material, points] : points_of) all.insert(all.end(), points.begin(), points.end());
    const PointGroup section(all);
    const Eigen::Matrix2d scale = section.axes * section.spread.cwiseSqrt().asDiagonal();
    const Eigen::Matrix2d inverse = scale.inverse();
    std::vector<SectionFibre> fibres;
    for (auto& [material, points] : points_of) {
        double area = 0.0;
        for (WeighedPoint& point : points) {
            point.at = inverse * (point.at - section.centre);
            area += point.area;
        }
        const double groups = settings.count * area / section.area / fibres_of_group;
        const auto cuts = static_cast<int>(std::lround(std::log2(std::max<double>(groups, least_groups))));
        std::vector<WeighedPoint> drawn;
        add_groups(std::move(points), cuts, drawn);
        for (const WeighedPoint& fibre : drawn)
            fibres.push_back({section.centre + scale * fibre.at, fibre.area, material});
    }
    return fibres;
}

}  // namespace gxrod
