#pragma once

#include <array>

#include "elements/lanes/general_rows.hpp"
#include "elements/lanes/kernels.hpp"
#include "elements/lanes/viscous_point.hpp"
#include "rotation/half_rotation.hpp"
#include "rotation/small_rotation.hpp"

// Internal force and tangent of elements `objective` (objective_map.hpp), for several at once. The legend is
// the same, but all is spatial: ρ_I = r_I − r_a, ψ_I with exp(ψ_I) R the axes of node I.
namespace gxrod {

// Constants, in the order of the rows of RodKernels.
template <int Nodes, class Real>
struct ObjectiveConstants {
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;
    static constexpr int point_count = Nodes - 1;

    struct Point {
        Real jacobian;  // ds/dξ
        Vec3 Gamma_0, Kappa_0;
    };

    struct Stiffness {
        Mat3 C_NN, C_NM, C_MM;
    };

    const double* stiffness;  // rows of all points
    // The quadrature, with shape functions and their slopes dN_I/dξ at its points.
    const double* weights;
    const double* shapes;
    const double* slopes;
    std::array<Point, point_count> points;
    std::array<Eigen::Quaternion<Real>, Nodes> triads;
    Eigen::Matrix<Real, Nodes, Nodes> mass;

    ObjectiveConstants(const double* section, const double* constants) {
        stiffness = section + RodKernels<Nodes>::shared_rows;
        weights = section + 3;
        shapes = weights + point_count;
        slopes = shapes + point_count * Nodes;
        LaneReader<Real> read(constants);
        for (Point& point : points) {
            point.jacobian = read.scalar();
            point.Gamma_0 = read.vector();
            point.Kappa_0 = read.vector();
        }
        for (auto& triad : triads) triad = read.quaternion();
        for (int i = 0; i < Nodes; ++i) {
            for (int j = i; j < Nodes; ++j) mass(i, j) = mass(j, i) = read.scalar();
        }
    }

    Stiffness stiffness_of(int point) const {
        LaneReader<Real> read(stiffness + 27 * point * static_cast<int>(Real::size));
        return {read.matrix(), read.matrix(), read.matrix()};
    }
};

// The nodes' section axes and positions.
template <int Nodes, class Real>
struct ObjectiveMotion {
    std::array<Eigen::Quaternion<Real>, Nodes> axes;
    std::array<Eigen::Matrix<Real, 3, 1>, Nodes> r;  // from the first node

    ObjectiveMotion(const ObjectiveConstants<Nodes, Real>& constants, LaneReader<Real>& read) {
        for (int i = 0; i < Nodes; ++i) axes[i] = read.quaternion() * constants.triads[i];
        r[0].setConstant(Real(0.0));
        for (int i = 1; i < Nodes; ++i) r[i] = read.vector();
    }
};

// Stands for rates of a section at rest, or without Kelvin-Voigt damping.
struct AtRest {};

// Rates of ρ and ψ relative to the frame.
template <int Nodes, class Real>
struct ObjectiveRates {
    std::array<Eigen::Matrix<Real, 3, 1>, Nodes> rho, psi;
    Eigen::Matrix<Real, 3, 1> omega_R;  // spin of the frame
    // Resultants are elasticity × strains + viscosity × strain rates.
    Real elasticity, viscosity;
};

template <int Nodes, class Real>
class ObjectiveState {
  public:
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;
    using Quat = Eigen::Quaternion<Real>;
    using Constants = ObjectiveConstants<Nodes, Real>;
    using Tangent = Eigen::Matrix<Real, 6 * Nodes, 6 * Nodes>;
    using Forces = NodeForces<Nodes, Real>;
    using Rates = ObjectiveRates<Nodes, Real>;

    explicit ObjectiveState(const ObjectiveMotion<Nodes, Real>& motion) {
        const auto& [axes, r] = motion;
        const Quat frame = find_frame(axes);
        frame_matrix_ = frame.toRotationMatrix();
        for (int i = 0; i < Nodes; ++i) {
            rho_[i] = r[i] - r[a];
            if (i != a && i != b) psi_[i] = find_rotation(axes[i] * frame.conjugate());
        }
    }

    // Whether all rotations are small enough for the series; if not, no other function may be called.
    bool is_small() const { return is_small_; }

    Rates compute_rates(const NodeRates<Nodes, Real>& nodes) const;

    // `MaybeRates` are Rates or AtRest.
    template <class MaybeRates>
    Forces compute_forces(const Constants& constants, const MaybeRates& rates) const {
        return compute_nodal_forces(sum_forces(constants, rates), invert_tangent_maps()).stacked;
    }
    // Computes the tangent by δr and δφ at fixed resultants of damping.
    template <class MaybeRates>
    void compute_tangent(const Constants& constants, const MaybeRates& rates, Tangent& rows) const;
    // Adds the derivative of the resultants of damping by the motion and the nodal rates.
    void add_viscous_tangent(const Constants& constants,
                             const Rates& rates,
                             const NodeRates<Nodes, Real>& nodes,
                             const NodeLinearizations<Nodes, Real>& linearizations,
                             Tangent& tangent) const;

  private:
    static constexpr bool has_pair = Nodes % 2 == 0;
    static constexpr int a = (Nodes - 1) / 2;
    static constexpr int b = Nodes / 2;  // a for an odd number of nodes
    static constexpr int point_count = Nodes - 1;
    using FrameRows = Eigen::Matrix<Real, 3, 6 * Nodes>;
    using FrameColumns = Eigen::Matrix<Real, 6 * Nodes, 3>;

    // One point of the quadrature: u′ = r′, spins and resultants.
    struct Point {
        int index;
        std::array<Real, Nodes> slopes;  // dN_I/ds
        const double* shapes;
        Real weight;
        Vec3 r_prime, psi, psi_prime;
        SmallRotation<Real> rotation;
        Mat3 T, Lambda;
        Vec3 n, m;
    };
    // Forces conjugate to ρ and ψ.
    struct LocalForces {
        std::array<Vec3, Nodes> n, mu;
    };
    using Inverses = std::array<SmallInverseRotation<Real>, Nodes>;
    struct NodalForces {
        Forces stacked;  // including the share of the frame
        Vec3 M;          // the moment on the frame
    };

    Vec3 find_rotation(const Quat& q) {
        is_small_ = is_small_ && xsimd::all(q.vec().squaredNorm() < Real(half_rotation::largest_square));
        const Real sign = xsimd::select(q.w() < Real(0.0), Real(-1.0), Real(1.0));
        const Real factor =
            Real(2.0) * sign * evaluate_series(half_rotation::arcsine_series, Real(q.vec().squaredNorm()));
        return factor * q.vec();
    }

    Quat find_frame(const std::array<Quat, Nodes>& axes) {
        if constexpr (has_pair) {
            const Quat relative = axes[b] * axes[a].conjugate();
            const Vec3 Phi = find_rotation(relative);
            psi_[b] = Real(0.5) * Phi;
            psi_[a] = -psi_[b];
            const Real z = Phi.squaredNorm();
            const Real t = evaluate_series(half_rotation::t_series, z);
            const Real t1 = evaluate_series(half_rotation::t1_series, z);
            tau_ = t * Phi;
            tau_gradient_ = (t1 * Phi) * Phi.transpose();
            tau_gradient_.diagonal().array() += t;
            Quat half;  // exp(Φ/2) = (1, τ)/|(1, τ)|
            half.w() = Real(1.0) / xsimd::sqrt(Real(1.0) + tau_.squaredNorm());
            half.vec() = half.w() * tau_;
            return half * axes[a];
        } else {
            psi_[a].setConstant(Real(0.0));
            return axes[a];
        }
    }

    Inverses invert_tangent_maps() const {
        return [this]<std::size_t... i>(std::index_sequence<i...>) {
            return Inverses{SmallInverseRotation<Real>(psi_[i])...};
        }(std::make_index_sequence<Nodes>());
    }

    // Rates of a point's r′, ψ and ψ′ relative to the frame, and the spin of the section relative to it.
    struct PointRates {
        Vec3 r_prime, psi, psi_prime, omega;
    };
    PointRates evaluate_rates(const Point& point, const Rates& rates) const;
    // Derivatives of the spin of a section and of its slope by the spins of the nodes, and their rates
    // relative to the frame.
    struct SpinMaps {
        std::array<Mat3, Nodes> spin, slope, spin_rate, slope_rate;
    };
    // The maps T(ψ_I)⁻¹, and their rates.
    struct InverseMaps {
        std::array<Mat3, Nodes> map, rate;
    };
    static SpinMaps compute_spin_maps(const Point& point,
                                      const PointRates& moving,
                                      const InverseMaps& inverses);
    void share_frame(const Vec3& tau_rate, SpinMaps& maps) const;
    static ViscousPoint<Nodes, Real> make_viscous_point(const Constants& constants,
                                                        const Point& point,
                                                        const PointRates& moving,
                                                        const SpinMaps& maps,
                                                        const Rates& rates);

    template <class MaybeRates>
    Point evaluate(const Constants& constants, int p, const MaybeRates& rates) const;
    template <class MaybeRates>
    LocalForces sum_forces(const Constants& constants, const MaybeRates& rates) const;
    static void add_forces(const Point& point, LocalForces& forces);
    static void add_stiffness(const Constants& constants, const Mat3& R, const Point& point, Tangent& k);
    NodalForces compute_nodal_forces(const LocalForces& local, const Inverses& inverses) const;
    void pull_and_push(const LocalForces& local, const Inverses& inverses, Tangent& rows) const;

    // Computes A_aᵀ x and A_bᵀ x, x A_a and x A_b, with A_a,b = ½(I ± [τ]×).
    template <class Matrix>
    Matrix share(const Matrix& x, double sign) const {
        Matrix shared = Real(0.5) * x;
        for (int j = 0; j < x.cols(); ++j) {
            const Vec3 column = x.col(j);
            shared.col(j) -= Real(0.5 * sign) * tau_.cross(column);
        }
        return shared;
    }

    bool is_small_ = true;
    Mat3 frame_matrix_;
    std::array<Vec3, Nodes> rho_, psi_;
    Vec3 tau_;  // τ for a pair; tau_gradient_ = ∂τ/∂Φ
    Mat3 tau_gradient_;
};

}  // namespace gxrod

#include "elements/lanes/objective_state_impl.hpp"
#include "elements/lanes/objective_viscosity_impl.hpp"
