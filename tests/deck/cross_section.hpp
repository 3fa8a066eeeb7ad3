#pragma once

#include <functional>

#include "rotation/types.hpp"

namespace gxrod::test {

// A point (y, z) of a cross-section from two coordinates that run from 0 to 1.
using SectionMap = std::function<Eigen::Vector2d(double, double)>;

// A cross-section of an isotropic material as a grid of elements in those coordinates.
struct SectionGrid {
    SectionMap map;
    int columns = 1;
    int rows = 1;
    bool closes = false;  // the second coordinate comes back to where it began
    double E = 1.0;
    double nu = 0.0;
};

// The 6×6 compliance, strains (x y z | rx ry rz) of resultants in this order, from the finite element
// solution for the warping displacements: no formula of Saint-Venant's is in it.
Mat6 compute_section_compliance(const SectionGrid& grid);

}  // namespace gxrod::test
