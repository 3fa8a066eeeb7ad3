#include "elements/rod/simo_map.hpp"

#include "rotation/tangent_map.hpp"

namespace gxrod {

template <int Nodes>
SimoMap<Nodes>::SimoMap(const Motions<Nodes>& motions, const std::array<Quat, Nodes>&) {
    for (int i = 0; i < Nodes; ++i) {
        local_.r.col(i) = motions[i]->r - motions[0]->r;
        local_.theta.col(i) = motions[i]->theta;
        inverse_tangents_[i] = tangent_map_inverse(motions[i]->theta);
    }
}

template <int Nodes>
LocalMotion<Nodes> SimoMap<Nodes>::compute_rates(const Motions<Nodes>& motions) const {
    LocalMotion<Nodes> rates;
    for (int i = 0; i < Nodes; ++i) {
        rates.r.col(i) = motions[i]->v - motions[0]->v;
        rates.theta.col(i) = inverse_tangents_[i] * motions[i]->omega;
    }
    return rates;
}

template <int Nodes>
void SimoMap<Nodes>::add_force(const NodalVector<Nodes>& local_force, NodalVector<Nodes>& force) const {
    for (int i = 0; i < Nodes; ++i) {
        force.template segment<3>(6 * i) += local_force.template segment<3>(6 * i);
        force.template segment<3>(6 * i + 3) +=
            inverse_tangents_[i].transpose() * local_force.template segment<3>(6 * i + 3);
    }
}

template <int Nodes>
NodalMatrix<Nodes> SimoMap<Nodes>::pull_rows(NodalMatrix<Nodes> rows) const {
    for (int i = 0; i < Nodes; ++i) {
        auto moment = rows.template middleRows<3>(6 * i + 3);
        moment = (inverse_tangents_[i].transpose() * moment).eval();
    }
    return rows;
}

template <int Nodes>
void SimoMap<Nodes>::add_tangent(const NodalVector<Nodes>& local_force,
                                 const NodalMatrix<Nodes>& local_tangent,
                                 const Linearizations<Nodes>& linearizations,
                                 NodalMatrix<Nodes>& tangent) const {
    NodalMatrix<Nodes> rows = pull_rows(local_tangent);
    for (int i = 0; i < Nodes; ++i) {
        const Vec3 conjugate = local_force.template segment<3>(6 * i + 3);
        rows.template block<3, 3>(6 * i + 3, 6 * i + 3) +=
            tangent_map_inverse_transpose_derivative(local_.theta.col(i), conjugate);
    }
    for (int j = 0; j < Nodes; ++j) {
        const double placement = linearizations[j]->placement;
        tangent.template middleCols<3>(6 * j) += placement * rows.template middleCols<3>(6 * j);
        tangent.template middleCols<3>(6 * j + 3) +=
            rows.template middleCols<3>(6 * j + 3) * (placement * inverse_tangents_[j]);
    }
}

template <int Nodes>
void SimoMap<Nodes>::add_rate_tangent(const Motions<Nodes>& motions,
                                      const NodalMatrix<Nodes>& local_tangent,
                                      const Linearizations<Nodes>& linearizations,
                                      NodalMatrix<Nodes>& tangent) const {
    const NodalMatrix<Nodes> rows = pull_rows(local_tangent);
    for (int j = 0; j < Nodes; ++j) {
        const NodeLinearization& linearization = *linearizations[j];
        // θ̇ = T(θ)⁻¹ ω.
        const Mat3 by_spin = inverse_tangents_[j] * linearization.d_omega +
                             linearization.placement *
                                 tangent_map_inverse_derivative(local_.theta.col(j), motions[j]->omega) *
                                 inverse_tangents_[j];
        tangent.template middleCols<3>(6 * j) += linearization.rate * rows.template middleCols<3>(6 * j);
        tangent.template middleCols<3>(6 * j + 3) += rows.template middleCols<3>(6 * j + 3) * by_spin;
    }
}

template class SimoMap<2>;
template class SimoMap<3>;
template class SimoMap<4>;
template class SimoMap<5>;

}  // namespace gxrod
