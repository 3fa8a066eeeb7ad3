#pragma once

#include <initializer_list>
#include <vector>

#include "cross_section/central_solutions.hpp"
#include "cross_section/walls/wall_mesh.hpp"
#include "rotation/types.hpp"

namespace gxrod {

constexpr double degree = 0.017453292519943295;

ElasticMaterial make_isotropic(double E, double nu);
ElasticMaterial make_orthotropic(const OrthotropicModuli& moduli);

// The stadium of VABS's multi-layer composite pipe (X9): its arcs have a layup of their own.
struct SampleWalls {
    WallOutline outline;
    std::vector<Layup> layups;
    std::vector<ElasticMaterial> materials;

    SectionMesh mesh(double refinement = 1.0) const;
};
SampleWalls make_pipe();
// A rectangular box with mitred corners, .953 × .53 outside, of plies .005 thick (X10).
SampleWalls make_box(const std::vector<double>& degrees);

CentralSolutions solve(const SectionMesh& mesh, const std::vector<ElasticMaterial>& materials);

// Returns the largest error of some entries, counted from 1; those off the diagonal over √(Kii Kjj).
struct MatrixEntry {
    int row, column;
    double value;
};
double find_worst_entry(const Mat6& matrix, std::initializer_list<MatrixEntry> entries);

double compute_area(const SectionMesh& mesh);

}  // namespace gxrod
