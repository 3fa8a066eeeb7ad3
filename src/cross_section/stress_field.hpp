#pragma once

#include <vector>

#include "cross_section/central_solutions.hpp"

// The stresses at the nodes of a section's mesh (CS9).
namespace gxrod {

// Resultants are (N, Vy, Vz, T, My, Mz), in section axes, about the origin of the mesh.

// A node in one of its layers. Stresses of the cells of the layer that meet there are averaged; those of
// different layers never are.
struct StressPoint {
    PlanePoint at;
    int layer = 0;
    PlanePoint wall;           // the unit vector t
    Mat6 stress_operator;      // H: stresses (xx, yy, zz, yz, xz, xy) = H × resultants
    bool is_singular = false;  // near a sharp corner, or where a cell is flat: left out of largest values
};

struct StressField {
    std::vector<StressPoint> points;
    std::vector<std::vector<int>> points_of_cells;  // an index in `points` for each node of each cell
};

// Computes the stress operator at all nodes.
StressField compute_stress_field(const SectionQuadrature& quadrature, const CentralSolutions& solutions);

// Integrates the stresses of unit resultants back to resultants, over the quadrature points: the identity up
// to round-off.
Mat6 integrate_stresses(const SectionQuadrature& quadrature, const CentralSolutions& solutions);

}  // namespace gxrod
