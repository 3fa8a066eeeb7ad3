#include "cross_section/section_properties.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace gxrod {
namespace {

// Stress by strain along x with no other stress.
double compute_axial_modulus(const Mat6& stiffness) { return 1.0 / stiffness.inverse()(0, 0); }

// Velocities of a point by those of the slice (v, ω).
Eigen::Matrix<double, 3, 6> compute_velocity_map(const PlanePoint& at) {
    Eigen::Matrix<double, 3, 6> map = Eigen::Matrix<double, 3, 6>::Zero();
    map.leftCols<3>().setIdentity();
    map(0, 4) = at.y();
    map(0, 5) = -at.x();
    map(1, 3) = -at.y();
    map(2, 3) = at.x();
    return map;
}

Vec3 plane_monomials(const PlanePoint& at) { return {1.0, at.x(), at.y()}; }

// Sums over the points of the section.
struct PlainSums {
    Mat3 areas = Mat3::Zero();  // of 1, y, z by pairs
    Mat6 mass = Mat6::Zero();
    // Weighted by the axial modulus: of 1, y, z by pairs, with ω, and of ω².
    Mat3 stiffness = Mat3::Zero();
    Vec3 with_warping = Vec3::Zero();
    double of_warping = 0.0;
};

void add_cell(const SectionQuadrature& quadrature,
              const CellPoints& points,
              const Eigen::VectorXd& torsion_warping,
              SectionProperties& properties,
              PlainSums& sums) {
    const double density = quadrature.material_of(*points.cell).density;
    const std::vector<int>& nodes = points.cell->nodes;
    double modulus = 0.0;
    for (std::size_t q = 0; q < points.at.size(); ++q) {
        if (q < points.stiffness.size()) {
            modulus = compute_axial_modulus(points.stiffness[q]);
            properties.stiffest = std::max(properties.stiffest, modulus);
        }
        const Vec3 monomials = plane_monomials(points.at[q]);
        const auto map = compute_velocity_map(points.at[q]);
        double omega = 0.0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            omega += (*points.shapes)(static_cast<Eigen::Index>(q), static_cast<Eigen::Index>(i)) *
                     torsion_warping[nodes[i]];
        }
        const double weight = points.weights[q];
        sums.areas += weight * monomials * monomials.transpose();
        sums.mass += weight * density * map.transpose() * map;
        sums.stiffness += weight * modulus * monomials * monomials.transpose();
        sums.with_warping += weight * modulus * omega * monomials;
        sums.of_warping += weight * modulus * omega * omega;
    }
}

// Sets couplings to zero that are those of the cells: sections with symmetries have none, their meshes some.
Mat6 without_round_off(const Mat6& stiffness) {
    constexpr double of_cells = 1e-7;
    const Vec6 scale = stiffness.diagonal().cwiseSqrt();
    Mat6 clean = stiffness;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            if (i != j && std::abs(stiffness(i, j)) < of_cells * scale[i] * scale[j]) clean(i, j) = 0.0;
        }
    }
    return clean;
}

// ∫ Hᵀ α T dA for T = 1, y and z: by the virtual work of unit resultants.
Eigen::Matrix<double, 6, 3> compute_thermal_strains(const SectionQuadrature& quadrature,
                                                    const CentralSolutions& solutions) {
    Eigen::Matrix<double, 6, 3> sum = Eigen::Matrix<double, 6, 3>::Zero();
    for (const CellPoints& points : quadrature.cells()) {
        const ElasticMaterial& material = quadrature.material_of(*points.cell);
        if (material.expansion.isZero(0.0)) continue;
        const double angle =
            quadrature.mesh().layers[static_cast<std::size_t>(points.cell->layer)].fibre_angle;
        const std::vector<Mat6> strains = compute_strain_operators(points, solutions);
        for (std::size_t q = 0; q < strains.size(); ++q) {
            const Vec6 free = turn_strain_from_ply(material.expansion, angle, points.walls[q]);
            sum += points.weights[q] * strains[q].transpose() * points.stiffness_at(q) * free *
                   plane_monomials(points.at[q]).transpose();
        }
    }
    return sum;
}

}  // namespace

double SectionProperties::warping_length() const {
    const double torsion = 1.0 / stiffness.inverse()(3, 3);
    return std::sqrt(std::max(warping_stiffness, 0.0) / torsion);
}

SectionProperties compute_properties(const SectionQuadrature& quadrature, const CentralSolutions& solutions) {
    SectionProperties properties;
    PlainSums sums;
    for (const CellPoints& points : quadrature.cells())
        add_cell(quadrature, points, solutions.torsion_warping, properties, sums);
    const Mat3& areas = sums.areas;
    properties.area = areas(0, 0);
    properties.centroid = areas.col(0).tail<2>() / properties.area;
    const PlanePoint& centroid = properties.centroid;
    properties.second_moment_y = areas(2, 2) - properties.area * centroid.y() * centroid.y();
    properties.second_moment_z = areas(1, 1) - properties.area * centroid.x() * centroid.x();
    properties.product_moment = areas(1, 2) - properties.area * centroid.x() * centroid.y();
    properties.stiffness = without_round_off(solutions.stiffness);
    properties.mass = sums.mass;
    // What a mean and turns of the slice can take up is no warping; this also moves it to the shear centre.
    properties.warping_stiffness =
        sums.of_warping - sums.with_warping.dot(sums.stiffness.ldlt().solve(sums.with_warping));
    properties.thermal_strains = compute_thermal_strains(quadrature, solutions).col(0);
    return properties;
}

Eigen::Matrix<double, 6, 2> compute_gradient_strains(const SectionQuadrature& quadrature,
                                                     const CentralSolutions& solutions) {
    return compute_thermal_strains(quadrature, solutions).rightCols<2>();
}

}  // namespace gxrod
