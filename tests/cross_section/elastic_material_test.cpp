#include "cross_section/elastic_material.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

constexpr OrthotropicModuli carbon{.E1 = 141e9,
                                   .E2 = 9.8e9,
                                   .E3 = 9.1e9,
                                   .G12 = 6e9,
                                   .G13 = 5e9,
                                   .G23 = 4.8e9,
                                   .nu12 = 0.3,
                                   .nu13 = 0.28,
                                   .nu23 = 0.34};
const Eigen::Vector2d slanted(std::cos(0.7), std::sin(0.7));

constexpr std::array<std::pair<int, int>, 6> entries{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

Mat3 tensor_of(const Vec6& stress) {
    Mat3 tensor;
    tensor << stress[0], stress[5], stress[4], stress[5], stress[1], stress[3], stress[4], stress[3],
        stress[2];
    return tensor;
}

// Axes 1 2 3 as columns, by rotations: of the fibre about 3, then of the wall about x.
Mat3 axes_by_rotations(double fibre_angle, const Eigen::Vector2d& wall) {
    const double turn = std::atan2(wall.y(), wall.x());
    return Mat3(Eigen::AngleAxisd(turn, Vec3::UnitX()) * Eigen::AngleAxisd(fibre_angle, Vec3::UnitZ()));
}

// Q_ijkl turned by four rotations, one an index.
Mat6 turn_as_tensor(const Mat6& stiffness, const Mat3& R) {
    const auto component = [](int i, int j) { return i == j ? i : 6 - i - j; };
    Mat6 turned = Mat6::Zero();
    for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 6; ++column) {
            const auto [i, j] = entries[static_cast<std::size_t>(row)];
            const auto [k, l] = entries[static_cast<std::size_t>(column)];
            for (int abcd = 0; abcd < 81; ++abcd) {
                const int a = abcd % 3, b = abcd / 3 % 3, c = abcd / 9 % 3, d = abcd / 27;
                turned(row, column) +=
                    R(i, a) * R(j, b) * R(k, c) * R(l, d) * stiffness(component(a, b), component(c, d));
            }
        }
    }
    return turned;
}

}  // namespace

TEST_CASE("An isotropic material has the stiffness of its Young's modulus and shear modulus",
          "[cross_section]") {
    const Mat6 stiffness = compute_isotropic_stiffness(210e9, 0.3);
    const Mat6 compliance = stiffness.inverse();
    CHECK(compliance(0, 0) == Approx(1 / 210e9));
    CHECK(compliance(0, 1) == Approx(-0.3 / 210e9));
    CHECK(compliance(5, 5) == Approx(2.6 / 210e9));
    const double G = 210e9 / 2.6;
    const OrthotropicModuli equal{210e9, 210e9, 210e9, G, G, G, 0.3, 0.3, 0.3};
    CHECK((compute_orthotropic_stiffness(equal) - stiffness).norm() < 1e-13 * stiffness.norm());
    CHECK((turn_stiffness(stiffness, 0.4, slanted) - stiffness).norm() < 1e-14 * stiffness.norm());
}

TEST_CASE("An orthotropic material strains as its moduli say", "[cross_section]") {
    const Mat6 stiffness = compute_orthotropic_stiffness(carbon);
    const Mat6 compliance = stiffness.inverse();
    CHECK(compliance(1, 0) == Approx(-carbon.nu12 / carbon.E1));
    CHECK(compliance(2, 0) == Approx(-carbon.nu13 / carbon.E1));
    CHECK(compliance(2, 1) == Approx(-carbon.nu23 / carbon.E2));
    CHECK(compliance(1, 1) == Approx(1 / carbon.E2));
    CHECK(compliance(2, 2) == Approx(1 / carbon.E3));
    CHECK(compliance(3, 3) == Approx(1 / carbon.G23));
    CHECK(compliance(4, 4) == Approx(1 / carbon.G13));
    CHECK(compliance(5, 5) == Approx(1 / carbon.G12));
    CHECK(stiffness == stiffness.transpose());
}

TEST_CASE("A stiffness turns as a tensor of fourth order", "[cross_section]") {
    const Mat6 stiffness = compute_orthotropic_stiffness(carbon);
    for (const double angle : {0.0, 0.3, -1.2, 2.0}) {
        const Mat6 turned = turn_stiffness(stiffness, angle, slanted);
        const Mat6 expected = turn_as_tensor(stiffness, axes_by_rotations(angle, slanted));
        CHECK((turned - expected).norm() < 1e-14 * stiffness.norm());
        const Mat6 half_turn = turn_stiffness(stiffness, angle + std::numbers::pi, slanted);
        CHECK((turned - half_turn).norm() < 1e-14 * stiffness.norm());
    }
}

TEST_CASE("Stresses and strains turn into and out of the axes of a ply", "[cross_section]") {
    Vec6 strain;
    strain << 1e-3, -2e-3, 5e-4, 7e-4, -3e-4, 9e-4;
    const double angle = 0.6;
    const Mat6 stiffness = compute_orthotropic_stiffness(carbon);
    const Vec6 stress =
        turn_stiffness(stiffness, angle, slanted) * turn_strain_from_ply(strain, angle, slanted);
    const Vec6 in_ply = turn_stress_to_ply(stress, angle, slanted);
    CHECK((in_ply - stiffness * strain).norm() < 1e-14 * in_ply.norm());
    const Mat3 axes = axes_by_rotations(angle, slanted);
    CHECK((axes.transpose() * tensor_of(stress) * axes - tensor_of(in_ply)).norm() < 1e-14 * in_ply.norm());
}

TEST_CASE("Moduli of a material that is not positive definite are found", "[cross_section]") {
    CHECK(find_fault(carbon).empty());
    OrthotropicModuli moduli = carbon;
    moduli.nu12 = 4.0;
    CHECK(find_fault(moduli) == "nu12 = 4 is more than √(E1/E2) = 3.79");
    moduli = carbon;
    moduli.nu23 = -1.1;
    CHECK(find_fault(moduli) == "nu23 = -1.1 is less than −√(E2/E3) = −1.04");
    moduli = carbon;
    moduli.nu13 = 5.0;
    CHECK(find_fault(moduli) == "nu13 = 5 is more than √(E1/E3) = 3.94");
    moduli = carbon;
    moduli.G13 = 0.0;
    CHECK(find_fault(moduli) == "G13 = 0 is not positive");
    moduli = carbon;
    moduli.nu12 = moduli.nu13 = 2.5;
    moduli.nu23 = 0.3;
    CHECK(find_fault(moduli) == "with nu12 = 2.5 and nu13 = 2.5, nu23 = 0.3 is more than 0.168");
    moduli.nu13 = -2.5;
    moduli.nu23 = -0.3;
    CHECK(find_fault(moduli) == "with nu12 = 2.5 and nu13 = -2.5, nu23 = -0.3 is less than -0.168");
}

TEST_CASE("The faults of moduli are those of their compliance", "[cross_section]") {
    int faults = 0;
    for (int i = 0; i < 1000; ++i) {
        OrthotropicModuli moduli = carbon;
        moduli.nu12 = -4.0 + 8.0 * (i % 10) / 9.1;
        moduli.nu13 = -4.0 + 8.0 * (i / 10 % 10) / 9.1;
        moduli.nu23 = -1.1 + 2.2 * (i / 100) / 9.1;
        Mat3 compliance;
        compliance << 1 / moduli.E1, -moduli.nu12 / moduli.E1, -moduli.nu13 / moduli.E1,
            -moduli.nu12 / moduli.E1, 1 / moduli.E2, -moduli.nu23 / moduli.E2,  //
            -moduli.nu13 / moduli.E1, -moduli.nu23 / moduli.E2, 1 / moduli.E3;
        const bool is_definite =
            Eigen::SelfAdjointEigenSolver<Mat3>(compliance).eigenvalues().minCoeff() > 0.0;
        CHECK(find_fault(moduli).empty() == is_definite);
        faults += is_definite ? 0 : 1;
    }
    CHECK(faults > 100);
    CHECK(faults < 900);
}
