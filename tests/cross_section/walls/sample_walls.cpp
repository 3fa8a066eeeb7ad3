#include "cross_section/walls/sample_walls.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

ElasticMaterial make_isotropic(double E, double nu) {
    ElasticMaterial material{.name = "isotropic"};
    material.stiffness = compute_isotropic_stiffness(E, nu);
    return material;
}

ElasticMaterial make_orthotropic(const OrthotropicModuli& moduli) {
    ElasticMaterial material{.name = "orthotropic"};
    material.stiffness = compute_orthotropic_stiffness(moduli);
    material.is_isotropic = false;
    return material;
}

SectionMesh SampleWalls::mesh(double refinement) const {
    return mesh_walls(outline, layups, {.refinement = refinement});
}

SampleWalls make_pipe() {
    const Layup flat{"flat", {{0, 0.1, 0.0}, {0, 0.1, 90.0 * degree}}};
    const Layup round{"round", {{0, 0.1, 45.0 * degree}, {0, 0.1, -45.0 * degree}}};
    WallOutline outline{.corners = {{{1.0, -0.5}},
                                    {{1.5, -0.5}, 0.5},
                                    {{1.5, 0.5}, 0.5},
                                    {{1.0, 0.5}},
                                    {{-1.0, 0.5}},
                                    {{-1.5, 0.5}, 0.5},
                                    {{-1.5, -0.5}, 0.5},
                                    {{-1.0, -0.5}}},
                        .is_closed = true,
                        .line = WallSide::right,
                        .layups = {1, 1, 1, 0, 1, 1, 1, 0}};
    return {std::move(outline),
            {flat, round},
            {make_orthotropic({20.59e6, 1.42e6, 1.42e6, 0.87e6, 0.87e6, 0.87e6, 0.42, 0.42, 0.42})}};
}

SampleWalls make_box(const std::vector<double>& degrees) {
    Layup layup{.name = "skin", .plies = {}};
    for (const double angle : degrees) layup.plies.push_back({0, 0.005, angle * degree});
    WallOutline outline{
        .corners = {{{-0.4765, -0.265}}, {{0.4765, -0.265}}, {{0.4765, 0.265}}, {{-0.4765, 0.265}}},
        .is_closed = true,
        .line = WallSide::right,
        .layups = {0}};
    return {std::move(outline),
            {layup},
            {make_orthotropic({20.59e6, 1.42e6, 1.42e6, 0.87e6, 0.87e6, 0.696e6, 0.30, 0.30, 0.34})}};
}

CentralSolutions solve(const SectionMesh& mesh, const std::vector<ElasticMaterial>& materials) {
    return solve_section(SectionQuadrature(mesh, materials));
}

double find_worst_entry(const Mat6& matrix, std::initializer_list<MatrixEntry> entries) {
    double worst = 0.0;
    for (const auto& [row, column, value] : entries) {
        const double found = matrix(row - 1, column - 1);
        const double scale = std::sqrt(matrix(row - 1, row - 1) * matrix(column - 1, column - 1));
        worst = std::max(worst, std::abs(found - value) / scale);
    }
    return worst;
}

double compute_area(const SectionMesh& mesh) {
    const std::vector<ElasticMaterial> materials(4, make_isotropic(1.0, 0.0));
    const SectionQuadrature quadrature(mesh, materials);
    double area = 0.0;
    for (const CellPoints& cell : quadrature.cells()) {
        for (const double weight : cell.weights) area += weight;
    }
    return area;
}

}  // namespace gxrod
