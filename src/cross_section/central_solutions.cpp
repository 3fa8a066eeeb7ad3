#include "cross_section/central_solutions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "cross_section/warping_system.hpp"

namespace gxrod {
namespace {

// Generalised strains that deform a slice: extension, twist and two curvatures. A shear Γy is a turn of the
// slice in its plane, −y in x, without strain.
constexpr std::array<int, 4> deforming{0, 3, 4, 5};

// Unit strains as columns.
Eigen::MatrixXd list_deforming_strains() {
    Eigen::MatrixXd strains = Eigen::MatrixXd::Zero(6, 4);
    for (int k = 0; k < 4; ++k) strains(deforming[static_cast<std::size_t>(k)], k) = 1.0;
    return strains;
}

// What is integrated of the stresses of fields.
struct Integrals {
    Eigen::MatrixXd warping_force;  // ∫ Bᵀ σ
    Eigen::MatrixXd slope_force;    // ∫ Nᵀ Sᵀ σ
    Eigen::MatrixXd resultants;     // ∫ (S Z)ᵀ σ, six rows
    Eigen::MatrixXd energy;         // ∫ εᵀ σ, of each column with each
};

Integrals integrate(const SectionQuadrature& quadrature, const WarpingFields& fields) {
    const Eigen::Index count = fields.count();
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(quadrature.unknowns(), count);
    Integrals sums{zero, zero, Eigen::MatrixXd::Zero(6, count), Eigen::MatrixXd::Zero(count, count)};
    for (const CellPoints& points : quadrature.cells()) {
        const PointFields strains = compute_strains(points, fields);
        PointFields stresses = compute_stresses(points, strains);
        weigh(points, stresses);
        add_warping_force(points, stresses, sums.warping_force);
        add_slope_force(points, stresses, sums.slope_force);
        add_resultants(points, stresses, sums.resultants);
        for (std::size_t i = 0; i < 6; ++i) sums.energy.noalias() += strains[i].transpose() * stresses[i];
    }
    return sums;
}

Eigen::MatrixXd pick_deforming(const Eigen::MatrixXd& rows) {
    Eigen::MatrixXd picked(4, rows.cols());
    for (int k = 0; k < 4; ++k) picked.row(k) = rows.row(deforming[static_cast<std::size_t>(k)]);
    return picked;
}

// θ′ = T θ of end loads: My′ = Vz, Mz′ = −Vy. Rows N, T, My, Mz.
Eigen::MatrixXd list_load_slopes() {
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(4, 6);
    slopes(2, 2) = 1.0;
    slopes(3, 1) = -1.0;
    return slopes;
}

Mat6 symmetric(const Eigen::MatrixXd& matrix) { return 0.5 * (matrix + matrix.transpose()); }

}  // namespace

CentralSolutions solve_section(const SectionQuadrature& quadrature) {
    const WarpingSystem system(quadrature);
    const Eigen::MatrixXd units = list_deforming_strains();
    // (CS3)
    const Eigen::MatrixXd unit_warping =
        system.solve(-integrate(quadrature, {.strain = units}).warping_force);
    const Integrals of_units = integrate(quadrature, {.warping = unit_warping, .strain = units});
    const Eigen::FullPivLU<Eigen::MatrixXd> central(pick_deforming(of_units.resultants));
    // (CS4)
    const Eigen::MatrixXd strain_slopes = central.solve(list_load_slopes());
    const Eigen::MatrixXd slope = unit_warping * strain_slopes;
    const Integrals of_slopes = integrate(quadrature, {.warping = slope, .strain = units * strain_slopes});
    const Integrals of_warping_slopes = integrate(quadrature, {.slope = slope});
    const Eigen::MatrixXd correction = system.solve(of_slopes.slope_force - of_warping_slopes.warping_force);
    const Integrals of_corrections = integrate(quadrature, {.warping = correction, .slope = slope});
    // (CS5)
    const Eigen::MatrixXd left = Eigen::MatrixXd::Identity(6, 6) - of_corrections.resultants;
    const Eigen::MatrixXd strains = central.solve(pick_deforming(left));
    CentralSolutions solutions;
    solutions.fields = {unit_warping * strains + correction, slope, units * strains};
    // (CS6)
    solutions.flexibility = symmetric(integrate(quadrature, solutions.fields).energy);
    solutions.stiffness = symmetric(solutions.flexibility.inverse());
    solutions.shear_defect = left.middleRows<2>(1).cwiseAbs().maxCoeff();
    solutions.torsion_warping.resize(quadrature.unknowns() / 3);
    for (Eigen::Index node = 0; node < solutions.torsion_warping.size(); ++node)
        solutions.torsion_warping[node] = unit_warping(3 * node, 1);
    return solutions;
}

std::vector<Mat6> compute_strain_operators(const CellPoints& points, const CentralSolutions& solutions) {
    const PointFields strains = compute_strains(points, solutions.fields);
    std::vector<Mat6> operators(points.at.size());
    for (std::size_t q = 0; q < operators.size(); ++q) {
        for (std::size_t i = 0; i < 6; ++i)
            operators[q].row(static_cast<Eigen::Index>(i)) = strains[i].row(static_cast<Eigen::Index>(q));
    }
    return operators;
}

}  // namespace gxrod
