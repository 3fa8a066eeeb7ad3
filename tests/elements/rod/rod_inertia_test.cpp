#include "elements/rod/rod_inertia.hpp"

#include <catch2/catch.hpp>

#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double length = 0.7;
constexpr double density = 1.3;  // ρA

struct Piece {
    Quat axes = RandomValues(31).rotation();
    Mat3 rotary = RandomValues(32).positive_definite<3>();
    RodInertia<2> inertia = make();

    RodInertia<2> make() const {
        Section section{"tube", Mat6::Identity(), Mat6::Zero()};
        section.mass.diagonal().head<3>().setConstant(density);
        section.mass.bottomRightCorner<3, 3>() = rotary;
        const Vec3 start(0.2, -0.4, 1.0);
        return {{start, start + axes * Vec3(length, 0.0, 0.0)}, {axes, axes}, section};
    }
    // The tangent that accelerations alone leave.
    NodalMatrix<2> compute_mass_matrix(const std::array<NodeMotion, 2>& nodal) const {
        NodeLinearization mass;
        mass.acceleration = 1.0;
        mass.d_alpha.setIdentity();
        NodalMatrix<2> matrix = NodalMatrix<2>::Zero();
        inertia.add_tangent({&nodal[0], &nodal[1]}, Vec3::Zero(), {&mass, &mass}, matrix);
        return matrix;
    }
};

}  // namespace

TEST_CASE("a line's mass matrix is ρAL/6 [2 1; 1 2]", "[elements][rod]") {
    const Piece piece;
    const NodalMatrix<2> matrix = piece.compute_mass_matrix({});
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
            const Mat3 expected = density * length / 6.0 * (i == j ? 2.0 : 1.0) * Mat3::Identity();
            CHECK(relative_difference(matrix.block<3, 3>(6 * i, 6 * j), expected) < 1e-14);
        }
    }
}

TEST_CASE("rotary inertia is half the piece's at each node, in the section's axes", "[elements][rod]") {
    const Piece piece;
    std::array<NodeMotion, 2> nodal;
    nodal[1].Lambda = RandomValues(33).rotation();
    const NodalMatrix<2> matrix = piece.compute_mass_matrix(nodal);
    for (int i = 0; i < 2; ++i) {
        const Mat3 R = (nodal[i].Lambda * piece.axes).toRotationMatrix();
        const Mat3 expected = 0.5 * length * R * piece.rotary * R.transpose();
        CHECK(relative_difference(matrix.block<3, 3>(6 * i + 3, 6 * i + 3), expected) < 1e-14);
        CHECK(matrix.block<3, 3>(6 * i, 6 * i + 3).isZero());
    }
    CHECK(matrix.block<3, 3>(3, 9).isZero());
}

TEST_CASE("a piece weighs and moves as its whole mass", "[elements][rod]") {
    const Piece piece;
    std::array<NodeMotion, 2> nodal;
    nodal[0].r = Vec3(0.2, -0.4, 1.0);
    nodal[1].r = nodal[0].r + Vec3(length, 0.0, 0.0);
    const Vec3 v(0.4, 0.1, -0.8);
    for (NodeMotion& motion : nodal) motion.v = v;
    const double mass = density * length;
    const Vec3 middle = 0.5 * (nodal[0].r + nodal[1].r);
    const Vec3 gravity(0.0, -1.0, -9.81);
    const Motions<2> motions{&nodal[0], &nodal[1]};
    CHECK(relative_difference(piece.inertia.momentum(motions).linear, mass * v) < 1e-14);
    CHECK(relative_difference(piece.inertia.momentum(motions).angular, mass * middle.cross(v)) < 1e-14);
    CHECK(relative_difference(piece.inertia.kinetic_energy(motions), 0.5 * mass * v.squaredNorm()) < 1e-14);
    CHECK(relative_difference(piece.inertia.gravity_potential(motions, gravity),
                              -mass * gravity.dot(middle)) < 1e-14);
    NodalVector<2> force = NodalVector<2>::Zero();
    piece.inertia.add_force(motions, gravity, force);
    CHECK(relative_difference(force.head<3>(), -0.5 * mass * gravity) < 1e-14);
    CHECK(relative_difference(force.segment<3>(6), -0.5 * mass * gravity) < 1e-14);
}

TEST_CASE("a spinning piece has the momentum of a thin bar", "[elements][rod]") {
    // About its middle, across its axis: ρA L³/12 + L ρI.
    const Piece piece;
    std::array<NodeMotion, 2> nodal;
    const Vec3 omega = piece.axes * Vec3(0.0, 0.0, 1.7);
    for (int i = 0; i < 2; ++i) {
        nodal[i].r = piece.axes * Vec3((i - 0.5) * length, 0.0, 0.0);
        nodal[i].v = omega.cross(nodal[i].r);
        nodal[i].omega = omega;
    }
    const Vec3 H = piece.axes.conjugate() * piece.inertia.momentum({&nodal[0], &nodal[1]}).angular;
    const Vec3 expected =
        1.7 * (density * std::pow(length, 3) / 12.0 * Vec3::UnitZ() + length * piece.rotary.col(2));
    CHECK(relative_difference(H, expected) < 1e-14);
}
