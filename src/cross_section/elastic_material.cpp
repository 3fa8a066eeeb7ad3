#include "cross_section/elastic_material.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <utility>

namespace gxrod {
namespace {

// Entries of a symmetric tensor in the order of components.
constexpr std::array<std::pair<int, int>, 6> tensor_entries{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

// Returns the axes 1 2 3 of a ply as columns, in x y z.
Mat3 find_ply_axes(double fibre_angle, const Eigen::Vector2d& wall) {
    const Vec3 normal(0.0, -wall.y(), wall.x());
    const Vec3 fibre(
        std::cos(fibre_angle), std::sin(fibre_angle) * wall.x(), std::sin(fibre_angle) * wall.y());
    Mat3 axes;
    axes << fibre, normal.cross(fibre), normal;
    return axes;
}

// Returns the 6×6 matrix of σ → R σ Rᵀ. Its transpose takes strains the other way.
Mat6 turn_of_stress(const Mat3& R) {
    Mat6 turn;
    for (int row = 0; row < 6; ++row) {
        const auto [i, j] = tensor_entries[static_cast<std::size_t>(row)];
        for (int column = 0; column < 6; ++column) {
            const auto [a, b] = tensor_entries[static_cast<std::size_t>(column)];
            turn(row, column) = R(i, a) * R(j, b) + (a == b ? 0.0 : R(i, b) * R(j, a));
        }
    }
    return turn;
}

// A modulus and what its message calls it.
using NamedModulus = std::pair<const char*, double>;

// Describes a Poisson's ratio that alone makes the compliance indefinite; i and j are "1" "2" "3".
std::string find_ratio_fault(const char* pair, double nu, double E_i, double E_j) {
    const double limit = std::sqrt(E_i / E_j);
    if (std::abs(nu) < limit) return {};
    return fmt::format("nu{} = {:.6g} is {} {}√(E{}/E{}) = {}{:.3g}",
                       pair,
                       nu,
                       nu > 0.0 ? "more than" : "less than",
                       nu > 0.0 ? "" : "−",
                       pair[0],
                       pair[1],
                       nu > 0.0 ? "" : "−",
                       limit);
}

// Describes a nu23 that nu12 and nu13 do not allow. With a = ν12 √(E2/E1), b = ν13 √(E3/E1) and
// c = ν23 √(E3/E2) the determinant 1 − a² − b² − c² − 2abc must be positive.
std::string find_joint_fault(const OrthotropicModuli& m) {
    const double a = m.nu12 * std::sqrt(m.E2 / m.E1);
    const double b = m.nu13 * std::sqrt(m.E3 / m.E1);
    const double c = m.nu23 * std::sqrt(m.E3 / m.E2);
    const double reach = std::sqrt((1.0 - a * a) * (1.0 - b * b));
    if (std::abs(c + a * b) < reach) return {};
    const bool is_above = c + a * b > 0.0;
    return fmt::format("with nu12 = {:.6g} and nu13 = {:.6g}, nu23 = {:.6g} is {} than {:.3g}",
                       m.nu12,
                       m.nu13,
                       m.nu23,
                       is_above ? "more" : "less",
                       ((is_above ? reach : -reach) - a * b) * std::sqrt(m.E2 / m.E3));
}

}  // namespace

Mat6 compute_isotropic_stiffness(double E, double nu) {
    const double G = E / (2.0 * (1.0 + nu));
    const double lame = 2.0 * G * nu / (1.0 - 2.0 * nu);
    Mat6 stiffness = Mat6::Zero();
    stiffness.topLeftCorner<3, 3>().setConstant(lame);
    stiffness.topLeftCorner<3, 3>().diagonal().array() += 2.0 * G;
    stiffness.bottomRightCorner<3, 3>().diagonal().setConstant(G);
    return stiffness;
}

std::string find_fault(const OrthotropicModuli& moduli) {
    const std::array<NamedModulus, 6> positive{{{"E1", moduli.E1},
                                                {"E2", moduli.E2},
                                                {"E3", moduli.E3},
                                                {"G12", moduli.G12},
                                                {"G13", moduli.G13},
                                                {"G23", moduli.G23}}};
    for (const auto& [name, value] : positive) {
        if (!(value > 0.0)) return fmt::format("{} = {:.6g} is not positive", name, value);
    }
    std::string fault = find_ratio_fault("12", moduli.nu12, moduli.E1, moduli.E2);
    if (fault.empty()) fault = find_ratio_fault("13", moduli.nu13, moduli.E1, moduli.E3);
    if (fault.empty()) fault = find_ratio_fault("23", moduli.nu23, moduli.E2, moduli.E3);
    return fault.empty() ? find_joint_fault(moduli) : fault;
}

Mat6 compute_orthotropic_stiffness(const OrthotropicModuli& moduli) {
    const auto& [E1, E2, E3, G12, G13, G23, nu12, nu13, nu23] = moduli;
    Mat3 compliance;
    compliance << 1.0 / E1, -nu12 / E1, -nu13 / E1,  //
        -nu12 / E1, 1.0 / E2, -nu23 / E2,            //
        -nu13 / E1, -nu23 / E2, 1.0 / E3;
    Mat6 stiffness = Mat6::Zero();
    stiffness.topLeftCorner<3, 3>() = compliance.llt().solve(Mat3::Identity());
    stiffness.bottomRightCorner<3, 3>().diagonal() << G23, G13, G12;
    return 0.5 * (stiffness + stiffness.transpose());
}

Mat6 turn_stiffness(const Mat6& stiffness, double fibre_angle, const Eigen::Vector2d& wall) {
    const Mat6 turn = turn_of_stress(find_ply_axes(fibre_angle, wall));
    return turn * stiffness * turn.transpose();
}

Vec6 turn_stress_to_ply(const Vec6& stress, double fibre_angle, const Eigen::Vector2d& wall) {
    const Mat3 to_ply = find_ply_axes(fibre_angle, wall).inverse();
    return turn_of_stress(to_ply) * stress;
}

Vec6 turn_strain_from_ply(const Vec6& strain, double fibre_angle, const Eigen::Vector2d& wall) {
    const Mat3 to_ply = find_ply_axes(fibre_angle, wall).inverse();
    return turn_of_stress(to_ply).transpose() * strain;
}

}  // namespace gxrod
