#include "elements/rod/objective_map.hpp"

#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

template <int Nodes>
ObjectiveMap<Nodes>::ObjectiveMap(const Motions<Nodes>& motions, const std::array<Quat, Nodes>& triads) {
    std::array<Quat, Nodes> axes;
    for (int i = 0; i < Nodes; ++i) axes[i] = motions[i]->Lambda * triads[i];
    find_frame(axes);
    for (int i = 0; i < Nodes; ++i) {
        local_.r.col(i) = frame_matrix_.transpose() * (motions[i]->r - motions[a]->r);
        if (i != a && i != b) {
            local_.theta.col(i) = log(frame_.conjugate() * axes[i]);
            largest_relative_rotation_ = std::max(largest_relative_rotation_, local_.theta.col(i).norm());
        }
        inverse_tangents_[i] = tangent_map_inverse(local_.theta.col(i));
    }
}

// With Φ the rotation from a to b and τ = tan(|Φ|/4) along it, half-way between a and b
// A_b = ½ T(Φ/2) T(Φ)⁻¹ = ½(I − [τ]×).
template <int Nodes>
void ObjectiveMap<Nodes>::find_frame(const std::array<Quat, Nodes>& axes) {
    local_.theta.setZero();
    if constexpr (has_pair) {
        const Vec3 Phi = log(axes[a].conjugate() * axes[b]);
        const Quat half = exp_quaternion(0.5 * Phi);
        frame_ = axes[a] * half;
        local_.theta.col(a) = -0.5 * Phi;
        local_.theta.col(b) = 0.5 * Phi;
        const Vec3 tau = half.vec() / half.w();
        share_of_a_ = 0.5 * (Mat3::Identity() + spin(tau));
        share_of_b_ = 0.5 * (Mat3::Identity() - spin(tau));
        tau_gradient_ =
            0.25 * (Mat3::Identity() + tau * tau.transpose() - spin(tau)) * tangent_map(0.5 * Phi);
        largest_relative_rotation_ = Phi.norm();
    } else {
        frame_ = axes[a];
        share_of_a_.setIdentity();
        share_of_b_.setZero();
        tau_gradient_.setZero();
    }
    frame_matrix_ = frame_.toRotationMatrix();
}

template <int Nodes>
auto ObjectiveMap<Nodes>::compute_frame_rates(const Motions<Nodes>& motions) const -> FrameRates {
    FrameRates rates;
    for (int i = 0; i < Nodes; ++i) {
        rates.v.col(i) = frame_matrix_.transpose() * (motions[i]->v - motions[a]->v);
        rates.omega.col(i) = frame_matrix_.transpose() * motions[i]->omega;
    }
    rates.omega_R = share_of_a_ * rates.omega.col(a);
    if constexpr (has_pair) rates.omega_R += share_of_b_ * rates.omega.col(b);
    return rates;
}

template <int Nodes>
LocalMotion<Nodes> ObjectiveMap<Nodes>::compute_rates(const Motions<Nodes>& motions) const {
    const FrameRates frame_rates = compute_frame_rates(motions);
    LocalMotion<Nodes> rates;
    for (int i = 0; i < Nodes; ++i) {
        const Vec3 rho = local_.r.col(i);
        rates.r.col(i) = frame_rates.v.col(i) + rho.cross(frame_rates.omega_R);
        rates.theta.col(i) = inverse_tangents_[i] * (frame_rates.omega.col(i) - frame_rates.omega_R);
    }
    return rates;
}

template <int Nodes>
Quat ObjectiveMap<Nodes>::interpolate_axes(const NodeValues<Nodes>& shape) const {
    return frame_ * exp_quaternion(local_.theta * shape);
}

template <int Nodes>
Eigen::Matrix<double, 3, 6 * Nodes> ObjectiveMap<Nodes>::compute_frame_spin() const {
    FrameRows spin = FrameRows::Zero();
    const auto turn_out = [&](const Mat3& share) -> Mat3 {
        return frame_matrix_ * share * frame_matrix_.transpose();
    };
    spin.template middleCols<3>(6 * a + 3) = turn_out(share_of_a_);
    if constexpr (has_pair) spin.template middleCols<3>(6 * b + 3) = turn_out(share_of_b_);
    return spin;
}

// ω = R (T(ψ) ψ̇ + ω_R), ψ = Σ N_I ψ_I.
template <int Nodes>
Vec3 ObjectiveMap<Nodes>::interpolate_spin(const Motions<Nodes>& motions,
                                           const NodeValues<Nodes>& shape) const {
    const Vec3 psi = local_.theta * shape;
    const Vec3 psi_rate = compute_rates(motions).theta * shape;
    return frame_matrix_ * (tangent_map(psi) * psi_rate + compute_frame_rates(motions).omega_R);
}

template <int Nodes>
auto ObjectiveMap<Nodes>::compute_frame_forces(const NodalVector<Nodes>& local_force) const -> FrameForces {
    FrameForces forces;
    forces.M.setZero();
    for (int i = 0; i < Nodes; ++i) {
        const Vec3 n = local_force.template segment<3>(6 * i);
        const Vec3 m = inverse_tangents_[i].transpose() * local_force.template segment<3>(6 * i + 3);
        const Vec3 rho = local_.r.col(i);
        forces.n.col(i) = n;
        forces.m.col(i) = m;
        forces.M -= rho.cross(n) + m;
        forces.stacked.template segment<3>(6 * i) = n;
        forces.stacked.template segment<3>(6 * i + 3) = m;
    }
    forces.stacked.template segment<3>(6 * a + 3) += share_of_a_.transpose() * forces.M;
    if constexpr (has_pair)
        forces.stacked.template segment<3>(6 * b + 3) += share_of_b_.transpose() * forces.M;
    return forces;
}

template <int Nodes>
void ObjectiveMap<Nodes>::add_force(const NodalVector<Nodes>& local_force, NodalVector<Nodes>& force) const {
    const FrameForces forces = compute_frame_forces(local_force);
    for (int i = 0; i < 2 * Nodes; ++i) {
        force.template segment<3>(3 * i) += frame_matrix_ * forces.stacked.template segment<3>(3 * i);
    }
}

template <int Nodes>
auto ObjectiveMap<Nodes>::pull_rows(NodalMatrix<Nodes>& rows) const -> FrameRows {
    FrameRows on_frame = FrameRows::Zero();
    for (int i = 0; i < Nodes; ++i) {
        auto moment = rows.template middleRows<3>(6 * i + 3);
        moment = (inverse_tangents_[i].transpose() * moment).eval();
        on_frame -= spin(local_.r.col(i)) * rows.template middleRows<3>(6 * i) + moment;
    }
    return on_frame;
}

template <int Nodes>
void ObjectiveMap<Nodes>::add_frame_rows(const FrameRows& on_frame, NodalMatrix<Nodes>& rows) const {
    rows.template middleRows<3>(6 * a + 3) += share_of_a_.transpose() * on_frame;
    if constexpr (has_pair) rows.template middleRows<3>(6 * b + 3) += share_of_b_.transpose() * on_frame;
}

template <int Nodes>
void ObjectiveMap<Nodes>::push_columns(FrameColumns by_frame, NodalMatrix<Nodes>& matrix) const {
    for (int i = 0; i < Nodes; ++i) {
        auto by_psi = matrix.template middleCols<3>(6 * i + 3);
        by_psi = (by_psi * inverse_tangents_[i]).eval();
        by_frame += matrix.template middleCols<3>(6 * i) * spin(local_.r.col(i)) - by_psi;
    }
    matrix.template middleCols<3>(6 * a + 3) += by_frame * share_of_a_;
    if constexpr (has_pair) matrix.template middleCols<3>(6 * b + 3) += by_frame * share_of_b_;
}

template <int Nodes>
void ObjectiveMap<Nodes>::add_turned_out(const NodalMatrix<Nodes>& matrix,
                                         const Linearizations<Nodes>& linearizations,
                                         NodalMatrix<Nodes>& tangent) const {
    for (int j = 0; j < 2 * Nodes; ++j) {
        const Mat3 columns = linearizations[j / 2]->placement * frame_matrix_.transpose();
        for (int i = 0; i < 2 * Nodes; ++i) {
            tangent.template block<3, 3>(3 * i, 3 * j) +=
                frame_matrix_ * matrix.template block<3, 3>(3 * i, 3 * j) * columns;
        }
    }
}

// δ(R f) = R (δf + δφ_R × f) for each force and moment f of a node, seen from R.
template <int Nodes>
void ObjectiveMap<Nodes>::add_tangent(const NodalVector<Nodes>& local_force,
                                      const NodalMatrix<Nodes>& local_tangent,
                                      const Linearizations<Nodes>& linearizations,
                                      NodalMatrix<Nodes>& tangent) const {
    const FrameForces forces = compute_frame_forces(local_force);
    NodalMatrix<Nodes> rows = local_tangent;
    FrameRows on_frame = pull_rows(rows);
    FrameColumns by_frame;
    for (int i = 0; i < Nodes; ++i) {
        const Vec3 conjugate = local_force.template segment<3>(6 * i + 3);
        const Mat3 D = tangent_map_inverse_transpose_derivative(local_.theta.col(i), conjugate);
        rows.template block<3, 3>(6 * i + 3, 6 * i + 3) += D;
        on_frame.template middleCols<3>(6 * i + 3) -= D;
        on_frame.template middleCols<3>(6 * i) += spin(forces.n.col(i));
        by_frame.template middleRows<3>(6 * i) = -spin(forces.stacked.template segment<3>(6 * i));
        by_frame.template middleRows<3>(6 * i + 3) = -spin(forces.stacked.template segment<3>(6 * i + 3));
    }
    add_frame_rows(on_frame, rows);
    if constexpr (has_pair) {
        const Mat3 H = 0.5 * spin(forces.M) * tau_gradient_;
        rows.template block<3, 3>(6 * a + 3, 6 * a + 3) -= H;
        rows.template block<3, 3>(6 * a + 3, 6 * b + 3) += H;
        rows.template block<3, 3>(6 * b + 3, 6 * a + 3) += H;
        rows.template block<3, 3>(6 * b + 3, 6 * b + 3) -= H;
    }
    push_columns(by_frame, rows);
    add_turned_out(rows, linearizations, tangent);
}

template <int Nodes>
auto ObjectiveMap<Nodes>::compute_rate_gradients(const FrameRates& rates) const -> RateGradients {
    RateGradients gradients{NodalMatrix<Nodes>::Zero(), FrameColumns::Zero()};
    // δω_R = by_psi (δψ_b − δψ_a) + by_R δφ_R.
    Mat3 by_psi = Mat3::Zero();
    Mat3 by_R = share_of_a_ * spin(rates.omega.col(a));
    if constexpr (has_pair) {
        by_psi = 0.5 * spin(rates.omega.col(b) - rates.omega.col(a)) * tau_gradient_;
        by_R += share_of_b_ * spin(rates.omega.col(b));
    }
    for (int i = 0; i < Nodes; ++i) {
        const Mat3 spin_rho = spin(local_.r.col(i));
        auto of_rho = gradients.by_motion.template middleRows<3>(6 * i);
        auto of_psi = gradients.by_motion.template middleRows<3>(6 * i + 3);
        of_rho.template middleCols<3>(6 * i) -= spin(rates.omega_R);
        of_psi.template middleCols<3>(6 * i + 3) +=
            tangent_map_inverse_derivative(local_.theta.col(i), rates.omega.col(i) - rates.omega_R);
        if constexpr (has_pair) {
            of_rho.template middleCols<3>(6 * b + 3) += spin_rho * by_psi;
            of_rho.template middleCols<3>(6 * a + 3) -= spin_rho * by_psi;
            of_psi.template middleCols<3>(6 * b + 3) -= inverse_tangents_[i] * by_psi;
            of_psi.template middleCols<3>(6 * a + 3) += inverse_tangents_[i] * by_psi;
        }
        gradients.by_frame.template middleRows<3>(6 * i) = spin(rates.v.col(i)) + spin_rho * by_R;
        gradients.by_frame.template middleRows<3>(6 * i + 3) =
            inverse_tangents_[i] * (spin(rates.omega.col(i)) - by_R);
    }
    return gradients;
}

template <int Nodes>
void ObjectiveMap<Nodes>::add_rate_tangent(const Motions<Nodes>& motions,
                                           const NodalMatrix<Nodes>& local_tangent,
                                           const Linearizations<Nodes>& linearizations,
                                           NodalMatrix<Nodes>& tangent) const {
    NodalMatrix<Nodes> rows = local_tangent;
    const FrameRows on_frame = pull_rows(rows);
    add_frame_rows(on_frame, rows);
    const RateGradients gradients = compute_rate_gradients(compute_frame_rates(motions));
    NodalMatrix<Nodes> by_placement = rows * gradients.by_motion;
    push_columns(rows * gradients.by_frame, by_placement);
    add_turned_out(by_placement, linearizations, tangent);
    // The rates themselves follow nodal rates as the motion follows spins.
    push_columns(FrameColumns::Zero(), rows);
    for (int j = 0; j < Nodes; ++j) {
        const Mat3 by_v = linearizations[j]->rate * frame_matrix_.transpose();
        const Mat3 by_omega = frame_matrix_.transpose() * linearizations[j]->d_omega;
        for (int i = 0; i < 2 * Nodes; ++i) {
            tangent.template block<3, 3>(3 * i, 6 * j) +=
                frame_matrix_ * rows.template block<3, 3>(3 * i, 6 * j) * by_v;
            tangent.template block<3, 3>(3 * i, 6 * j + 3) +=
                frame_matrix_ * rows.template block<3, 3>(3 * i, 6 * j + 3) * by_omega;
        }
    }
}

template class ObjectiveMap<2>;
template class ObjectiveMap<3>;
template class ObjectiveMap<4>;
template class ObjectiveMap<5>;

}  // namespace gxrod
