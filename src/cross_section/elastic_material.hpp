#pragma once

#include <optional>
#include <string>

#include "rotation/types.hpp"

// Linear elastic materials of cross-sections, in their own axes 1 2 3. Components are in the order
// 11 22 33 23 13 12; shear strains are the engineer's, twice those of the tensor.
namespace gxrod {

// The strengths of a ply, all positive: tension and compression along the fibres (X) and across (Y), shear in
// the plane of the ply (12, and 13) and across the fibres (23).
struct PlyStrength {
    double Xt = 0.0, Xc = 0.0, Yt = 0.0, Yc = 0.0, S12 = 0.0, S23 = 0.0;
    double f12 = -0.5;  // of Tsai and Wu: F12 = f12 √(F11 F22)
};

struct ElasticMaterial {
    std::string name;
    Mat6 stiffness = Mat6::Zero();  // stresses from strains
    double density = 0.0;
    Vec6 expansion = Vec6::Zero();  // free strains for each degree
    bool is_isotropic = true;
    bool yields = false;  // at the yield stress, fibre by fibre
    std::optional<double> yield_stress = std::nullopt;
    std::optional<PlyStrength> strength = std::nullopt;
};

// Moduli of an orthotropic material; nu_ij: strain j is −nu_ij stress i/E_i.
struct OrthotropicModuli {
    double E1, E2, E3;
    double G12, G13, G23;
    double nu12, nu13, nu23;
};

// Computes the stiffness of an isotropic material; −1 < nu < ½.
Mat6 compute_isotropic_stiffness(double E, double nu);

// Returns what is wrong with moduli: which ratio is too large for a positive definite material, and its
// limit. Empty if nothing is.
std::string find_fault(const OrthotropicModuli& moduli);

// Computes the stiffness of an orthotropic material without a fault.
Mat6 compute_orthotropic_stiffness(const OrthotropicModuli& moduli);

// Returns a stiffness, given in axes 1 2 3, in the axes x y z of a section, whose order of components is xx
// yy zz yz xz xy: 1 lies along cos θ x + sin θ t, 3 along n = x × t. `wall` is the unit vector t, (y, z).
Mat6 turn_stiffness(const Mat6& stiffness, double fibre_angle, const Eigen::Vector2d& wall);

// Returns stresses of the axes x y z in the axes 1 2 3.
Vec6 turn_stress_to_ply(const Vec6& stress, double fibre_angle, const Eigen::Vector2d& wall);

// Returns strains of the axes 1 2 3, such as those of heat, in the axes x y z.
Vec6 turn_strain_from_ply(const Vec6& strain, double fibre_angle, const Eigen::Vector2d& wall);

}  // namespace gxrod
