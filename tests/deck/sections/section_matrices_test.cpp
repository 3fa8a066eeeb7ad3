#include "deck/sections/section_matrices.hpp"

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::string fault_of(const std::optional<MatrixFault>& fault) {
    return fault ? fault->entry + ": " + fault->message : "";
}

std::string stiffness_fault(Mat6 matrix) { return fault_of(check_stiffness_matrix(matrix)); }
std::string mass_fault(Mat6 matrix) { return fault_of(check_mass_matrix(matrix)); }

Mat6 make_diagonal() {
    Mat6 matrix = Mat6::Zero();
    matrix.diagonal() << 1e6, 4e5, 4e5, 50, 80, 900;
    return matrix;
}

// Of mass 2 with its centre at d and the inertia J about it.
Mat6 make_slice(const Vec3& d, const Mat3& J) {
    Mat6 matrix;
    const Mat3 D = spin(d);
    matrix << 2.0 * Mat3::Identity(), -2.0 * D, 2.0 * D, J - 2.0 * D * D;
    return matrix;
}

}  // namespace

TEST_CASE("A stiffness matrix can couple anything, if it is symmetric and positive definite", "[deck]") {
    Mat6 matrix = make_diagonal();
    CHECK(stiffness_fault(matrix).empty());
    matrix(0, 4) = matrix(4, 0) = 1e3;
    matrix(3, 5) = matrix(5, 3) = -20;
    CHECK(stiffness_fault(matrix).empty());
    matrix(5, 3) *= 1.0 + 1e-12;
    REQUIRE_FALSE(check_stiffness_matrix(matrix));
    CHECK(matrix == matrix.transpose());
}

TEST_CASE("An impossible stiffness matrix is reported by its entry", "[deck]") {
    Mat6 matrix = make_diagonal();
    matrix(4, 3) = 10.0;
    CHECK(stiffness_fault(matrix) == "[4][3]: expected a symmetric matrix, found 10 here and 0 at [3][4]");
    // Small compared with the largest entry, but not with its own.
    matrix = make_diagonal();
    matrix(4, 3) = 1e-6;
    CHECK(stiffness_fault(matrix) == "[4][3]: expected a symmetric matrix, found 1e-06 here and 0 at [3][4]");
    matrix = make_diagonal();
    matrix(2, 2) = 0.0;
    CHECK(stiffness_fault(matrix) == "[2][2]: expected a number greater than 0 on the diagonal, found 0");
    matrix = make_diagonal();
    matrix(3, 4) = matrix(4, 3) = 100.0;
    CHECK(stiffness_fault(matrix) ==
          ": expected a positive definite matrix; this one gives no energy to the strain rx 1, ry -0.7906");
}

TEST_CASE("A mass matrix is that of a rigid slice, offset or not", "[deck]") {
    const Mat3 J = Vec3(0.03, 0.02, 0.015).asDiagonal();
    CHECK(mass_fault(make_slice(Vec3::Zero(), J)).empty());
    CHECK(mass_fault(make_slice(Vec3(0, 0.3, -0.4), J)).empty());
    const Mat3 turned = exp_matrix({0.3, 0.2, 0.1});
    CHECK(mass_fault(make_slice(Vec3(0.1, 0.3, -0.4), turned * J * turned.transpose())).empty());
}

TEST_CASE("An impossible mass matrix is reported by its entry", "[deck]") {
    const Mat3 J = Vec3(0.03, 0.02, 0.015).asDiagonal();
    const std::string slice = " as in the inertia of a rigid slice, [m 1, −m [d]×; m [d]×, J], found ";
    Mat6 matrix = make_slice(Vec3(0, 0.3, -0.4), J);
    matrix(2, 2) = 3.0;
    CHECK(mass_fault(matrix) == "[2][2]: expected 2" + slice + "3");
    matrix = make_slice(Vec3(0, 0.3, -0.4), J);
    matrix(0, 1) = matrix(1, 0) = 0.1;
    CHECK(mass_fault(matrix) == "[0][1]: expected 0" + slice + "0.1");
    matrix = make_slice(Vec3(0, 0.3, -0.4), J);
    matrix(1, 4) = matrix(4, 1) = 0.1;
    CHECK(mass_fault(matrix) == "[1][4]: expected 0" + slice + "0.1");
    matrix = make_slice(Vec3(0, 0.3, -0.4), J);
    matrix(0, 4) = matrix(4, 0) = 0.7;
    CHECK(mass_fault(matrix) == "[0][4]: expected -0.8" + slice + "0.7");
    // A centre of mass so far off that the inertia about it would be negative.
    matrix = make_slice(Vec3(0, 0.3, 0), J);
    matrix.bottomRightCorner<3, 3>() = J;
    CHECK(mass_fault(matrix).starts_with(
        ": expected a positive definite matrix; this one gives no energy to the motion "));
}

}  // namespace gxrod::test
