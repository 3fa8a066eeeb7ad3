#pragma once

#include "rotation/cross_products.hpp"
#include "rotation/half_rotation.hpp"

// Internal force and tangent of the element `objective` with two nodes a and b. Its one force point lies in
// the frame R, half-way between the nodes: Γ = Rᵀ(r_b − r_a)/L − Γ₀ and K = Φ/L − K₀ (docs/theory/rods.md).
//
// Legend, spatial: l = r_b − r_a; n, M resultants (moment_), phi = R Φ; m = n × l the moment of the shear
// force on R; u = δr_b − δr_a, w = ½(I + [τ]×) δφ_a + ½(I − [τ]×) δφ_b the spin of R, p = X (δφ_b − δφ_a) =
// δΦ relative to R.
namespace gxrod {

template <class Real>
struct TwoNodeRod {
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;
    using Quat = Eigen::Quaternion<Real>;

    Real length;
    Vec3 Gamma_0, Kappa_0;
    Mat3 C_NN, C_NM, C_MM;  // the stiffness of the section by blocks

    // Resultants at the force point, material.
    struct Strains {
        Vec3 Gamma, Kappa;
    };
    struct Resultants {
        Vec3 N, M;
    };
    // The element's forces on its nodes: the force n on b, −n on a, and the moments.
    struct Forces {
        Vec3 n, moment_a, moment_b;
    };
    // Derivatives of n and of the moments by u (that is, by r_b, and by r_a with the sign changed) and the
    // spins.
    struct Tangents {
        Mat3 n_u, n_a, n_b;
        Mat3 a_u, a_a, a_b;
        Mat3 b_u, b_a, b_b;
    };

    // Computes the force strain in the frame R.
    Vec3 compute_force_strain(const Mat3& frame, const Vec3& l) const {
        return (frame.transpose() * l) / length - Gamma_0;
    }
    Vec3 compute_moment_strain(const HalfRotation<Real>& rotation) const {
        return rotation.Phi / length - Kappa_0;
    }

    // A state, with all values that forces and tangents share.
    class State {
      public:
        State(const TwoNodeRod& rod, const HalfRotation<Real>& rotation, const Quat& axes_a, const Vec3& l)
            : rod_(rod), rotation_(rotation), frame_((axes_a * rotation.half).toRotationMatrix()), l_(l) {
            phi_ = frame_ * rotation.Phi;
            tau_ = frame_ * rotation.tau;
            set_resultants(compute_resultants());
        }

        Resultants compute_resultants(const Vec3& Gamma, const Vec3& Kappa) const {
            return {rod_.C_NN * Gamma + rod_.C_NM * Kappa, rod_.C_NM.transpose() * Gamma + rod_.C_MM * Kappa};
        }
        // Computes the resultants of the strains.
        Resultants compute_resultants() const {
            return compute_resultants(compute_force_strain(), compute_moment_strain());
        }
        // Computes the resultants of the strains plus these.
        Resultants compute_resultants_beside(const Vec3& Gamma, const Vec3& Kappa) const {
            return compute_resultants(compute_force_strain() + Gamma, compute_moment_strain() + Kappa);
        }
        // Computes the first-order strain increments for u and the spins of a and b.
        Strains compute_strain_increments(const Vec3& u, const Vec3& spin_a, const Vec3& spin_b) const {
            const Vec3 w = compute_frame_spin(spin_a, spin_b);
            const Vec3 p = compute_phi_increment(spin_a, spin_b);
            return {frame_.transpose() * (u + l_.cross(w)) / rod_.length,
                    frame_.transpose() * p / rod_.length};
        }
        // The resultants after an increment.
        Resultants advance_resultants(const Vec3& u, const Vec3& spin_a, const Vec3& spin_b) const {
            const auto [Gamma, Kappa] = compute_strain_increments(u, spin_a, spin_b);
            return compute_resultants_beside(Gamma, Kappa);
        }
        // Compute w and p.
        Vec3 compute_frame_spin(const Vec3& spin_a, const Vec3& spin_b) const {
            return Real(0.5) * (spin_a + spin_b - tau_.cross(Vec3(spin_b - spin_a)));
        }
        Vec3 compute_phi_increment(const Vec3& spin_a, const Vec3& spin_b) const {
            const Vec3 difference = spin_b - spin_a;
            return rotation_.x * difference + (rotation_.y * phi_.dot(difference)) * phi_;
        }
        // Replaces the resultants of the strains by these for forces and tangents.
        void set_resultants(const Resultants& resultants) {
            n_ = frame_ * resultants.N;
            moment_ = frame_ * resultants.M;
            m_ = n_.cross(l_);
            moment_b_ = rotation_.x * moment_ + (rotation_.y * phi_.dot(moment_)) * phi_ +
                        Real(0.5) * (m_ + tau_.cross(m_));
        }

        Real energy() const {
            return Real(0.5) * rod_.length *
                   (n_.dot(frame_ * compute_force_strain()) + moment_.dot(frame_ * compute_moment_strain()));
        }
        const Mat3& frame() const { return frame_; }
        const Vec3& phi() const { return phi_; }
        const Vec3& tau() const { return tau_; }
        Forces forces() const { return {n_, m_ - moment_b_, moment_b_}; }
        Tangents compute_tangents() const;

      private:
        Vec3 compute_force_strain() const { return rod_.compute_force_strain(frame_, l_); }
        Vec3 compute_moment_strain() const { return rod_.compute_moment_strain(rotation_); }
        // Computes X A + ½(I + [τ]×) B: the change of the moment on b by changes of M and m.
        Mat3 pull(const Mat3& A, const Mat3& B) const {
            return rotation_.x * A + (rotation_.y * phi_) * (phi_.transpose() * A) +
                   Real(0.5) * (B + cross_columns(tau_, B));
        }
        // Turns derivatives by w and p into the derivative by the spin of b; the derivative by the spin of a
        // is by_w less that.
        Mat3 push(const Mat3& by_w, const Mat3& by_p) const {
            return Real(0.5) * (by_w - cross_rows(by_w, tau_)) + rotation_.x * by_p +
                   (rotation_.y * (by_p * phi_)) * phi_.transpose();
        }

        const TwoNodeRod& rod_;
        const HalfRotation<Real>& rotation_;
        Mat3 frame_;
        Vec3 l_, n_, moment_, phi_, tau_, m_, moment_b_;
    };
};

template <class Real>
auto TwoNodeRod<Real>::State::compute_tangents() const -> Tangents {
    const Mat3 R_per_length = frame_ / rod_.length;
    const Mat3 C_nn = R_per_length * rod_.C_NN * frame_.transpose();
    const Mat3 C_nm = R_per_length * rod_.C_NM * frame_.transpose();
    const Mat3 C_mm = R_per_length * rod_.C_MM * frame_.transpose();
    const Mat3 C_mn = C_nm.transpose();
    // δm = δn × l + n × δl, δl = u + l × w; a force or moment f turns with R: w × f.
    const Mat3 m_u = cross_matrix(n_) - cross_columns(l_, C_nn);
    const Mat3 m_w = cross_rows(m_u, l_);
    const Mat3 m_p = -cross_columns(l_, C_nm);
    const Mat3 n_w = cross_rows(C_nn, l_) - cross_matrix(n_);
    const Mat3 b_w = pull(cross_rows(C_mn, l_), m_w) - cross_matrix(moment_b_);
    // The changes δX M and δτ × m add to it.
    const Real along = phi_.dot(moment_);
    Mat3 b_p = pull(C_mm, m_p) +
               (rotation_.x1 * moment_ + (rotation_.y1 * along) * phi_ -
                (Real(0.5) * rotation_.t1) * m_.cross(phi_)) *
                   phi_.transpose() +
               (rotation_.y * phi_) * moment_.transpose() -
               cross_matrix<Real>((Real(0.5) * rotation_.t) * m_);
    b_p.diagonal().array() += rotation_.y * along;
    // Derivatives of the sum of both moments, which is m.
    const Mat3 sum_w = m_w - cross_matrix(m_);
    const Mat3 sum_b = push(sum_w, m_p);

    Tangents tangents;
    tangents.n_u = C_nn;
    tangents.n_b = push(n_w, C_nm);
    tangents.n_a = n_w - tangents.n_b;
    tangents.b_u = pull(C_mn, m_u);
    tangents.b_b = push(b_w, b_p);
    tangents.b_a = b_w - tangents.b_b;
    tangents.a_u = m_u - tangents.b_u;
    tangents.a_b = sum_b - tangents.b_b;
    tangents.a_a = sum_w - sum_b - tangents.b_a;
    return tangents;
}

}  // namespace gxrod
