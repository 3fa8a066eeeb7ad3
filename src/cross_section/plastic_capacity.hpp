#pragma once

#include <optional>

#include "cross_section/section_quadrature.hpp"

namespace gxrod {

// The resultants at which a section yields as a whole, each by itself.
struct PlasticCapacity {
    double axial_force = 0.0;  // ∫ f dA
    double moment_y = 0.0;     // ∫ f |z − z₀| dA about the axis that halves the force
    double moment_z = 0.0;
    PlanePoint centre = PlanePoint::Zero();  // where the axial force acts, ∫ f (y, z) dA over ∫ f dA
};

// Computes them from the yield stresses f of the materials; nullopt if one of them has none. Cells that an
// axis cuts are cut into straight triangles, other ones integrated as they are.
std::optional<PlasticCapacity> compute_plastic_capacity(const SectionQuadrature& quadrature);

}  // namespace gxrod
