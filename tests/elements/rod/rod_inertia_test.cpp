#include "elements/rod/rod_inertia.hpp"

#include "numerics/lagrange.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double length = 0.7;
constexpr double density = 1.3;  // ρA
const Quat axes = RandomValues(31).rotation();
const Mat3 rotary = RandomValues(32).positive_definite<3>();  // per length, about the centre of mass
const Vec3 start(0.2, -0.4, 1.0);

// Of a section whose centre of mass is `offset` from its node, section axes.
Section make_section(const Vec3& offset) {
    const Mat3 spin_d = spin(offset);
    Section section{"tube", Mat6::Identity()};
    section.mass << density * Mat3::Identity(), -density * spin_d, density * spin_d,
        rotary - density * spin_d * spin_d;
    return section;
}

template <int Nodes>
struct Piece {
    RodElementGeometry<Nodes> geometry;
    RodInertia<Nodes> inertia;

    explicit Piece(const Vec3& offset)
        : geometry(make_geometry()),
          inertia(geometry, std::make_shared<const RodSection>(make_section(offset))) {}

    static RodElementGeometry<Nodes> make_geometry() {
        RodElementGeometry<Nodes> made;
        const NodeValues<Nodes> at = compute_node_positions<Nodes>();
        for (int i = 0; i < Nodes; ++i) {
            made.nodes[i] = i;
            made.positions[i] = start + axes * Vec3(0.5 * (1.0 + at[i]) * length, 0.0, 0.0);
            made.triads[i] = axes;
        }
        return made;
    }
    // Turned about the origin as one.
    std::array<NodeMotion, Nodes> make_motions(const Quat& turn = Quat::Identity()) const {
        std::array<NodeMotion, Nodes> nodal;
        for (int i = 0; i < Nodes; ++i) {
            nodal[i].r = turn * geometry.positions[i];
            nodal[i].Lambda = turn;
        }
        return nodal;
    }
    static Motions<Nodes> point_at(const std::array<NodeMotion, Nodes>& nodal) {
        Motions<Nodes> pointers;
        for (int i = 0; i < Nodes; ++i) pointers[i] = &nodal[i];
        return pointers;
    }
    // The tangent that accelerations alone leave.
    NodalMatrix<Nodes> compute_mass_matrix(const std::array<NodeMotion, Nodes>& nodal) const {
        NodeLinearization mass;
        mass.acceleration = 1.0;
        mass.d_alpha.setIdentity();
        Linearizations<Nodes> linearizations;
        linearizations.fill(&mass);
        NodalMatrix<Nodes> matrix = NodalMatrix<Nodes>::Zero();
        inertia.add_tangent(point_at(nodal), Vec3::Zero(), linearizations, matrix);
        return matrix;
    }
    // Velocities of nodes that move as one with (v, ω) about the origin.
    static Eigen::Matrix<double, 6 * Nodes, 6> make_rigid_motions(
        const std::array<NodeMotion, Nodes>& nodal) {
        Eigen::Matrix<double, 6 * Nodes, 6> motions;
        for (int i = 0; i < Nodes; ++i) {
            motions.template middleRows<6>(6 * i).setIdentity();
            motions.template block<3, 3>(6 * i, 3) = -spin(nodal[i].r);
        }
        return motions;
    }
};

template <class Visit>
void for_each_piece(const Vec3& offset, Visit&& visit) {
    visit(Piece<2>(offset));
    visit(Piece<3>(offset));
    visit(Piece<4>(offset));
    visit(Piece<5>(offset));
}

// The inertia of the whole piece about the origin: ∫ ρA (|x|² I − x xᵀ) ds + L × rotary, x = the line of
// centres of mass, straight.
Mat6 make_exact_inertia(const Quat& turn, const Vec3& offset) {
    const Mat3 R = (turn * axes).toRotationMatrix();
    const double mass = density * length;
    const Vec3 middle = turn * start + R * (offset + Vec3(0.5 * length, 0.0, 0.0));
    const Vec3 along = R.col(0);
    const Mat3 about_middle = mass * length * length / 12.0 * (Mat3::Identity() - along * along.transpose()) +
                              length * R * rotary * R.transpose();
    Mat6 inertia;
    inertia << mass * Mat3::Identity(), -mass * spin(middle), mass * spin(middle),
        about_middle - mass * spin(middle) * spin(middle);
    return inertia;
}

}  // namespace

TEST_CASE("a line's mass matrix is ρAL/6 [2 1; 1 2]", "[elements][rod]") {
    const Piece<2> piece(Vec3::Zero());
    const NodalMatrix<2> matrix = piece.compute_mass_matrix(piece.make_motions());
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
            const Mat3 expected = density * length / 6.0 * (i == j ? 2.0 : 1.0) * Mat3::Identity();
            CHECK(relative_difference(matrix.block<3, 3>(6 * i, 6 * j), expected) < 1e-14);
        }
    }
}

TEST_CASE("rotary inertia is half the piece's at each node, in the section's axes", "[elements][rod]") {
    const Piece<2> piece(Vec3::Zero());
    auto nodal = piece.make_motions();
    nodal[1].Lambda = RandomValues(33).rotation();
    const NodalMatrix<2> matrix = piece.compute_mass_matrix(nodal);
    for (int i = 0; i < 2; ++i) {
        const Mat3 R = (nodal[i].Lambda * axes).toRotationMatrix();
        const Mat3 expected = 0.5 * length * R * rotary * R.transpose();
        CHECK(relative_difference(matrix.block<3, 3>(6 * i + 3, 6 * i + 3), expected) < 1e-14);
        CHECK(matrix.block<3, 3>(6 * i, 6 * i + 3).isZero());
    }
    CHECK(matrix.block<3, 3>(3, 9).isZero());
}

TEST_CASE("a piece that moves as one has the mass and inertia of a rigid body, offset or not",
          "[elements][rod]") {
    for (const Vec3& offset : {Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.4, -0.3), Vec3(0.2, -1.0, 3.0)}) {
        for_each_piece(offset, [&]<int Nodes>(const Piece<Nodes>& piece) {
            INFO(Nodes << " nodes, offset " << offset.transpose());
            const Quat turn = RandomValues(34).rotation();
            auto nodal = piece.make_motions(turn);
            const auto rigid = piece.make_rigid_motions(nodal);
            const NodalMatrix<Nodes> matrix = piece.compute_mass_matrix(nodal);
            const Mat6 expected = make_exact_inertia(turn, offset);
            CHECK(relative_difference(rigid.transpose() * matrix * rigid, expected) < 1e-14);
            const Vec6 rates = RandomValues(35).matrix<6, 1>();
            const Eigen::Matrix<double, 6 * Nodes, 1> velocities = rigid * rates;
            for (int i = 0; i < Nodes; ++i) {
                nodal[i].v = velocities.template segment<3>(6 * i);
                nodal[i].omega = velocities.template segment<3>(6 * i + 3);
            }
            const Momentum momentum = piece.inertia.momentum(piece.point_at(nodal));
            Vec6 stacked;
            stacked << momentum.linear, momentum.angular;
            CHECK(relative_difference(stacked, expected * rates) < 1e-14);
            CHECK(relative_difference(piece.inertia.kinetic_energy(piece.point_at(nodal)),
                                      0.5 * rates.dot(expected * rates)) < 1e-14);
        });
    }
}

TEST_CASE("the kinetic energy of any motion is positive, however large the offset", "[elements][rod]") {
    // Up to ten radii of gyration. Centres of mass move by a shear of the nodes' motions, which leaves the
    // determinant of the mass matrix as it is without an offset.
    const double radius = std::sqrt(rotary.trace() / density);
    RandomValues random(36);
    for (const double factor : {0.1, 1.0, 10.0}) {
        for_each_piece(factor * radius * random.direction(), [&]<int Nodes>(const Piece<Nodes>& piece) {
            INFO(Nodes << " nodes, offset of " << factor << " radii");
            const Eigen::MatrixXd matrix = piece.compute_mass_matrix(piece.make_motions(random.rotation()));
            CHECK(relative_difference(matrix, Eigen::MatrixXd(matrix.transpose())) < 1e-15);
            CHECK(find_symmetric_eigenvalues(matrix)[0] > 0.0);
            const Piece<Nodes> central(Vec3::Zero());
            const Eigen::MatrixXd central_matrix = central.compute_mass_matrix(central.make_motions());
            CHECK(find_determinant(matrix) == Approx(find_determinant(central_matrix)).epsilon(1e-9));
        });
    }
}

TEST_CASE("gravity pulls at the centre of mass and so turns an offset piece", "[elements][rod]") {
    const Vec3 gravity(0.0, -1.0, -9.81);
    const Vec3 offset(0.0, 0.4, -0.3);
    const Quat turn = RandomValues(37).rotation();
    const Mat6 exact = make_exact_inertia(turn, offset);
    for_each_piece(offset, [&]<int Nodes>(const Piece<Nodes>& piece) {
        INFO(Nodes << " nodes");
        const auto nodal = piece.make_motions(turn);
        NodalVector<Nodes> force = NodalVector<Nodes>::Zero();
        piece.inertia.add_force(piece.point_at(nodal), gravity, force);
        Vec6 about_origin = Vec6::Zero();
        for (int i = 0; i < Nodes; ++i) {
            const Vec3 f = force.template segment<3>(6 * i);
            about_origin.head<3>() += f;
            about_origin.tail<3>() += nodal[i].r.cross(f) + force.template segment<3>(6 * i + 3);
        }
        const Vec6 weight = -exact.leftCols<3>() * gravity;
        CHECK(relative_difference(about_origin, weight) < 1e-14);
        CHECK(relative_difference(
                  piece.inertia.gravity_potential(piece.point_at(nodal), gravity),
                  -density * length *
                      gravity.dot(turn * start + turn * axes * (offset + Vec3(0.5 * length, 0.0, 0.0)))) <
              1e-14);
    });
}
