#pragma once

#include <span>

#include "cross_section/section_quadrature.hpp"

// Saint-Venant's solutions of a prismatic rod with any section (Giavotto et al. 1983, Borri et al. 1992,
// Morandini et al. 2010): warping and strains for the six resultants, which vary along the rod as end loads
// make them vary.
namespace gxrod {

// The answer to unit resultants (N, Vy, Vz, T, My, Mz) in the axes of the section, about the origin of the
// mesh: a column for each. Strains everywhere follow from (CS1).
struct CentralSolutions {
    WarpingFields fields;
    Mat6 flexibility = Mat6::Zero();  // strains (Γ, K) by resultants: ∫ εᵀ Q ε
    Mat6 stiffness = Mat6::Zero();    // its inverse
    Eigen::VectorXd torsion_warping;  // x-part of the warping for unit twist: ω at the nodes
    double shear_defect = 0.0;        // by how much shear forces miss their unit: round-off
};

// Computes them with one factorization; equations (CS3) to (CS6). Throws SectionError if the section does not
// hold together.
CentralSolutions solve_section(const SectionQuadrature& quadrature);

// Computes the strains of the solutions at the points of a cell: 6×6, a column for each resultant, for each
// point. Times the stiffness at the point this is the stress operator H of (CS9).
std::vector<Mat6> compute_strain_operators(const CellPoints& points, const CentralSolutions& solutions);

}  // namespace gxrod
