#include "model/sections/section_frame.hpp"

#include <cmath>
#include <vector>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Any symmetric matrix.
Mat6 some_matrix() {
    Mat6 root;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) root(i, j) = std::sin(1.0 + 7.0 * i + 3.0 * j * j);
    }
    return root * root.transpose();
}

// Of points with masses in the plane of y and z: energies of rigid motions about the origin.
struct Particle {
    double mass, y, z;
};

Mat6 inertia_of(const std::vector<Particle>& particles) {
    Mat6 inertia = Mat6::Zero();
    for (const Particle& particle : particles) {
        Eigen::Matrix<double, 3, 6> velocity;  // v + ω × r
        velocity.setZero();
        for (int i = 0; i < 6; ++i) {
            const Vec3 v = i < 3 ? Vec3(Vec3::Unit(i)) : Vec3::Zero();
            const Vec3 w = i < 3 ? Vec3::Zero() : Vec3(Vec3::Unit(i - 3));
            velocity.col(i) = v + w.cross(Vec3(0.0, particle.y, particle.z));
        }
        inertia += particle.mass * velocity.transpose() * velocity;
    }
    return inertia;
}

}  // namespace

TEST_CASE("matrices of sections move there and back", "[model][sections]") {
    const SectionFrame frame{0.7, -0.3, 0.9};
    const Mat6 matrix = some_matrix();
    CHECK_FALSE(move_from(frame, matrix).isApprox(matrix, 1e-3));
    CHECK(move_to(frame, move_from(frame, matrix)).isApprox(matrix, 1e-14));
    CHECK(move_from(frame, move_to(frame, matrix)).isApprox(matrix, 1e-14));
    CHECK(move_from({}, matrix) == matrix);
}

TEST_CASE("a moved inertia is that of the same particles", "[model][sections]") {
    const SectionFrame frame{0.7, -0.3, 0.9};
    const std::vector<Particle> seen{{1.0, 0.2, 0.3}, {2.0, -0.4, 0.1}, {0.5, 0.3, -0.6}};
    std::vector<Particle> there = seen;
    for (Particle& particle : there) {
        const double c = std::cos(frame.turn);
        const double s = std::sin(frame.turn);
        particle = {particle.mass,
                    frame.y + c * particle.y - s * particle.z,
                    frame.z + s * particle.y + c * particle.z};
    }
    CHECK(move_from(frame, inertia_of(seen)).isApprox(inertia_of(there), 1e-14));
}

TEST_CASE("a quarter turn swaps y and z without round-off", "[model][sections]") {
    Mat6 matrix = Mat6::Zero();
    matrix.diagonal() << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0;
    Mat6 swapped = Mat6::Zero();
    swapped.diagonal() << 1.0, 3.0, 2.0, 4.0, 6.0, 5.0;
    const Mat6 moved = move_from({0.0, 0.0, 0.5 * M_PI}, matrix);
    CHECK(moved.isApprox(swapped, 1e-15));
    CHECK(moved.isDiagonal(0.0));
}

}  // namespace gxrod::test
