// The internal force of a rod element once more, as one reads it in docs/theory/rods.md: the interpolation,
// the strains, their variation, the sum. No closed form, no chain of matrices; slopes are differences.
#include "elements/element_samples.hpp"
#include "rotation/tangent_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Positions and section axes of the nodes.
template <int Nodes>
struct Shape {
    std::array<Vec3, Nodes> r;
    std::array<Mat3, Nodes> Q;
};

// The objective element, (R13) to (R17): Q(ξ) = R exp(Σ N_I ψ_I), where exp(ψ_I) = Rᵀ Q_I and R is the triad
// of the middle node, or half-way between the two middle nodes a and b.
template <int Nodes>
struct PlainRod {
    static constexpr int a = (Nodes - 1) / 2, b = Nodes / 2;
    Shape<Nodes> nodes;
    Mat3 R = nodes.Q[a] * exp_matrix(0.5 * log(Mat3(nodes.Q[a].transpose() * nodes.Q[b])));

    Vec3 psi(int i) const { return log(Mat3(R.transpose() * nodes.Q[i])); }
    Vec3 psi_at(double xi) const {
        Vec3 sum = Vec3::Zero();
        for (int i = 0; i < Nodes; ++i) sum += compute_shape_functions<Nodes>(xi)[i] * psi(i);
        return sum;
    }
    Mat3 Q_at(double xi) const { return R * exp_matrix(psi_at(xi)); }
    Vec3 slope_at(double xi) const {  // dr/dξ
        Vec3 sum = Vec3::Zero();
        for (int i = 0; i < Nodes; ++i) sum += compute_shape_slopes<Nodes>(xi)[i] * nodes.r[i];
        return sum;
    }
    Vec6 strain_at(double xi, double ds) const {  // Γ = Qᵀ r′ and K = axial(Qᵀ Q′), nothing subtracted
        const Mat3 Q = Q_at(xi);
        const Mat3 dQ = differentiate([&](double h) { return Q_at(xi + h); });
        Vec6 strain;
        strain << Q.transpose() * slope_at(xi) / ds, axial(Q.transpose() * dQ) / ds;
        return strain;
    }
    // The spin of R, from the spins of the nodes a and b: half-way, δR = ½ T(Φ/2) δΦ on top of a.
    Vec3 spin_of_R(const Vec3& at_a, const Vec3& at_b) const {
        const Mat3 back = nodes.Q[a].transpose();
        const Vec3 Phi = log(Mat3(back * nodes.Q[b]));
        const Vec3 d_Phi = tangent_map_inverse(Phi) * (back * at_b - exp_matrix(Phi) * (back * at_a));
        return nodes.Q[a] * (0.5 * tangent_map(0.5 * Phi) * d_Phi + exp_matrix(0.5 * Phi) * (back * at_a));
    }
    // The spin δφ(ξ) = δφ_R + R T(ψ) Σ N_I δψ_I, δψ_I = T(ψ_I)⁻¹ Rᵀ (δφ_I − δφ_R), when node k alone turns.
    Vec3 spin_at(double xi, int k, const Vec3& turn) const {
        const Vec3 of_R = spin_of_R(k == a ? turn : Vec3::Zero(), k == b ? turn : Vec3::Zero());
        Vec3 d_psi = Vec3::Zero();
        for (int i = 0; i < Nodes; ++i) {
            const Vec3 relative = R.transpose() * ((i == k ? turn : Vec3::Zero()) - of_R);
            d_psi += compute_shape_functions<Nodes>(xi)[i] * (tangent_map_inverse(psi(i)) * relative);
        }
        return of_R + R * (tangent_map(psi_at(xi)) * d_psi);
    }
    // f · δu = Σ w ds (N · δΓ + M · δK), δΓ = Qᵀ (δr′ + r′ × δφ), δK = Qᵀ δφ′, at Nodes − 1 Gauss points.
    NodalVector<Nodes> internal_force(const Mat6& C, const Shape<Nodes>& start) const {
        NodalVector<Nodes> force = NodalVector<Nodes>::Zero();
        for (const auto& [xi, weight] : compute_gauss_rule<Nodes - 1>()) {
            const double ds = PlainRod{start}.slope_at(xi).norm();  // ds/dξ
            const Vec6 resultants = C * (strain_at(xi, ds) - PlainRod{start}.strain_at(xi, ds));
            const Vec3 n = Q_at(xi) * resultants.head<3>();
            const Vec3 m = Q_at(xi) * resultants.tail<3>();
            for (int k = 0; k < Nodes; ++k) {
                force.template segment<3>(6 * k) += weight * compute_shape_slopes<Nodes>(xi)[k] * n;
                for (int axis = 0; axis < 3; ++axis) {
                    const Vec3 turn = Vec3::Unit(axis);
                    const Vec3 d_phi = differentiate([&](double h) { return spin_at(xi + h, k, turn); });
                    force[6 * k + 3 + axis] +=
                        weight * (n.dot(slope_at(xi).cross(spin_at(xi, k, turn))) + m.dot(d_phi));
                }
            }
        }
        return force;
    }
};

template <int Nodes>
void check_force_of_pieces() {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        INFO(Nodes << " nodes, seed " << seed);
        RandomValues random(70 + seed);
        const RodPiece<Nodes> piece = make_rod_piece<Nodes>(random);
        const ObjectiveElement<Nodes> element(piece.geometry, piece.section);
        Shape<Nodes> start, now;
        std::array<NodeMotion, Nodes> nodal;
        const Quat turn = random.rotation();
        for (int i = 0; i < Nodes; ++i) {
            nodal[i].r = turn * piece.geometry.positions[i] + random.vector(0.1);
            nodal[i].Lambda = exp_quaternion(random.vector(0.4)) * turn;
            start.r[i] = piece.geometry.positions[i];
            start.Q[i] = piece.geometry.triads[i].toRotationMatrix();
            now.r[i] = nodal[i].r;
            now.Q[i] = nodal[i].Lambda * start.Q[i];
        }
        NodalVector<Nodes> force = NodalVector<Nodes>::Zero();
        element.add_internal_force(
            ElementSample<ObjectiveElement<Nodes>>::point_at(nodal), Remembered{}, force);
        CHECK(relative_difference(
                  force, PlainRod<Nodes>{now}.internal_force(piece.section.stiffness, start)) < 1e-10);
    }
}

}  // namespace

TEST_CASE("the internal force is the virtual work of the plain formulas", "[elements][rod]") {
    check_force_of_pieces<2>();
    check_force_of_pieces<3>();
    check_force_of_pieces<4>();
    check_force_of_pieces<5>();
}
