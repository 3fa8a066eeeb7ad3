#pragma once

#include <optional>

#include "cross_section/central_solutions.hpp"

namespace gxrod {

// The constants of a section about the origin of its mesh, order x y z rx ry rz.
struct SectionProperties {
    double area = 0.0;
    PlanePoint centroid = PlanePoint::Zero();
    // ∫ z² dA, ∫ y² dA and ∫ y z dA about the centroid.
    double second_moment_y = 0.0, second_moment_z = 0.0, product_moment = 0.0;
    Mat6 stiffness = Mat6::Zero();
    Mat6 mass = Mat6::Zero();  // of a slice of unit length
    // Axial force by which restrained warping resists, E Iw: ∫ Ẽ ω² dA about the shear centre, with the axial
    // modulus Ẽ.
    double warping_stiffness = 0.0;
    Vec6 thermal_strains = Vec6::Zero();  // free strains (Γ, K) for each degree
    double stiffest = 0.0;                // largest axial modulus of the materials present

    // ℓ = √(E Iw/(G J)): how far restrained warping reaches along the rod.
    double warping_length() const;
};

// Computes the constants of a solved section.
SectionProperties compute_properties(const SectionQuadrature& quadrature, const CentralSolutions& solutions);

// Computes the free strains (Γ, K) for each degree per length by which a section gets hotter along y and
// along z, its origin staying as it is.
Eigen::Matrix<double, 6, 2> compute_gradient_strains(const SectionQuadrature& quadrature,
                                                     const CentralSolutions& solutions);

}  // namespace gxrod
