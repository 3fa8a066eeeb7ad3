#include "integrators/coupled_stages.hpp"

#include <Eigen/LU>
#include <cassert>
#include <cmath>

#include "numerics/eigenvalues.hpp"
#include "rotation/tangent_map.hpp"
#include "state/increment.hpp"

namespace gxrod {

CoupledStages::CoupledStages(const Matrix& a, Vector fractions, bool ends_with_stage)
    : inverse_(a.inverse()), fractions_(std::move(fractions)), ends_with_stage_(ends_with_stage) {
    const Eigen::Index count = fractions_.size();
    const ComplexEigen eigen = find_complex_eigen(inverse_);
    const Eigen::MatrixXcd& V = eigen.vectors;
    const Eigen::MatrixXcd to_equations = V.inverse();
    Matrix powers(count, count);
    for (Eigen::Index j = 0; j < count; ++j)
        for (Eigen::Index m = 0; m < count; ++m) powers(j, m) = std::pow(fractions_[j] - 1.0, m);
    carried_ = powers.inverse().bottomRows(count - 1);
    to_real_ = from_real_ = Vector::Zero(count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const std::complex<double> factor = eigen.values[k];
        if (factor.imag() > 0.0) {
            complex_factor_ = factor;
            to_complex_ = to_equations.row(k).transpose();
            from_complex_ = V.col(k);
        } else if (factor.imag() == 0.0) {
            real_factor_ = factor.real();
            to_real_ = to_equations.row(k).transpose().real();
            from_real_ = V.col(k).real();
        }
    }
}

CoupledStages CoupledStages::make_radau_5() {
    const double root = std::sqrt(6.0);
    Matrix a(3, 3);
    a << (88.0 - 7.0 * root) / 360.0, (296.0 - 169.0 * root) / 1800.0, (-2.0 + 3.0 * root) / 225.0,
        (296.0 + 169.0 * root) / 1800.0, (88.0 + 7.0 * root) / 360.0, (-2.0 - 3.0 * root) / 225.0,
        (16.0 - root) / 36.0, (16.0 + root) / 36.0, 1.0 / 9.0;
    CoupledStages scheme(a, Vector{{(4.0 - root) / 10.0, (4.0 + root) / 10.0, 1.0}}, true);
    scheme.weights_ = a.row(2).transpose();
    scheme.end_ = Vector{{0.0, 0.0, 1.0}};
    scheme.error_order_ = 4;
    scheme.error_weights_ = Vector{{-(13.0 + 7.0 * root) / 3.0, (-13.0 + 7.0 * root) / 3.0, -1.0 / 3.0}};
    return scheme;
}

CoupledStages CoupledStages::make_gauss_4() {
    const double root = std::sqrt(3.0);
    Matrix a(2, 2);
    a << 0.25, 0.25 - root / 6.0, 0.25 + root / 6.0, 0.25;
    CoupledStages scheme(a, Vector{{0.5 - root / 6.0, 0.5 + root / 6.0}}, false);
    scheme.weights_ = Vector{{0.5, 0.5}};
    scheme.end_ = Vector{{-root, root}};
    return scheme;
}

std::vector<double> CoupledStages::power_weights() const {
    std::vector<double> weights{0.0};
    weights.insert(weights.end(), weights_.begin(), weights_.end());
    return weights;
}

void CoupledStages::start(State& state) const {
    state.carried_previous.assign(state.trial.size() * static_cast<std::size_t>(carried_count()), {});
    state.carried_trial = state.carried_previous;
}

void CoupledStages::predict(State& state,
                            const Stage& step,
                            Prediction prediction,
                            const ThreadTeam& team) const {
    const auto count = static_cast<std::size_t>(stage_count());
    const auto carried =
        prediction == Prediction::from_last_step ? static_cast<std::size_t>(carried_count()) : 0;
    state.stage_motions.resize(count);
    for (std::vector<NodeMotion>& motions : state.stage_motions) motions.resize(state.previous.size());
    team.for_each_range(state.previous.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t j = 0; j < count; ++j) {
            const double t = fractions_[static_cast<Eigen::Index>(j)] * step.time_step;
            for (std::size_t i = first; i < last; ++i) {
                const NodeMotion& from = state.previous[i];
                Vec3 a = 0.5 * from.a, alpha = 0.5 * from.alpha;
                double power = 1.0;
                for (std::size_t m = 1; m <= carried; ++m) {
                    power *= t;
                    const CarriedAcceleration& more = state.carried_previous[i * carried + m - 1];
                    const double weight = power / static_cast<double>((m + 1) * (m + 2));
                    a += weight * more.a;
                    alpha += weight * more.alpha;
                }
                if (carried > 0) {
                    const Vec3 change = from.alpha + 0.5 * t * state.carried_previous[i * carried].alpha;
                    alpha += t / 12.0 * change.cross(from.omega);
                }
                NodeMotion& to = state.stage_motions[j][i];
                to = from;
                place(from, from.r + t * (from.v + t * a), t * (from.omega + t * alpha), to);
            }
        }
    });
}

void CoupledStages::carry(State& state, double time_step, std::size_t node) const {
    const Eigen::Index count = carried_.rows();
    double scale = 1.0;
    for (Eigen::Index m = 0; m < count; ++m) {
        scale /= time_step;
        CarriedAcceleration& sum =
            state.carried_trial[node * static_cast<std::size_t>(count) + static_cast<std::size_t>(m)];
        sum = {};
        for (Eigen::Index j = 0; j < carried_.cols(); ++j) {
            const NodeMotion& motion = state.stage_motions[static_cast<std::size_t>(j)][node];
            sum.a += scale * carried_(m, j) * motion.a;
            sum.alpha += scale * carried_(m, j) * motion.alpha;
        }
    }
}

void CoupledStages::update_stages(State& state, const Stage& step, const ThreadTeam& team) const {
    const Matrix by_time = inverse_ / step.time_step;
    const Eigen::Index count = fractions_.size();
    using Vectors = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;
    team.for_each_range(state.previous.size(), [&](std::size_t first, std::size_t last) {
        Vectors r(3, count), theta(3, count), v(3, count), omega(3, count);
        for (std::size_t i = first; i < last; ++i) {
            const NodeMotion& previous = state.previous[i];
            for (Eigen::Index j = 0; j < count; ++j) {
                const NodeMotion& motion = state.stage_motions[static_cast<std::size_t>(j)][i];
                r.col(j) = motion.r - previous.r;
                theta.col(j) = motion.theta;
            }
            v = r * by_time.transpose();
            omega = theta * by_time.transpose();
            for (Eigen::Index j = 0; j < count; ++j) {
                NodeMotion& motion = state.stage_motions[static_cast<std::size_t>(j)][i];
                motion.v = v.col(j);
                motion.omega = tangent_map(motion.theta) * omega.col(j);
                v.col(j) -= previous.v;
                omega.col(j) = motion.omega - previous.omega;
            }
            const Vectors a = v * by_time.transpose();
            const Vectors alpha = omega * by_time.transpose();
            for (Eigen::Index j = 0; j < count; ++j) {
                NodeMotion& motion = state.stage_motions[static_cast<std::size_t>(j)][i];
                motion.a = a.col(j);
                motion.alpha = alpha.col(j);
            }
        }
    });
}

// δω_i = Σ_k ω_ik δφ_k with ω_ik = T(θ_i) b_ik/Δt T(θ_k)⁻¹, and for i = k the change of T(θ_i) too;
// δα_j = Σ_i b_ji δω_i/Δt.
void CoupledStages::linearize(const State& state,
                              double time_step,
                              int j,
                              int k,
                              std::vector<NodeLinearization>& linearizations,
                              const ThreadTeam& team) const {
    const Matrix by_time = inverse_ / time_step;
    const double acceleration = by_time.row(j).dot(by_time.col(k));
    const auto theta_of = [&](int i, std::size_t node) -> const Vec3& {
        return state.stage_motions[static_cast<std::size_t>(i)][node].theta;
    };
    linearizations.resize(state.previous.size());
    team.for_each_range(linearizations.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t node = first; node < last; ++node) {
            const Mat3 inverse = tangent_map_inverse(theta_of(k, node));
            const auto d_omega = [&](int i) -> Mat3 {
                Mat3 derivative = by_time(i, k) * tangent_map(theta_of(i, node));
                if (i == k) {
                    Vec3 theta_dot = Vec3::Zero();
                    for (int l = 0; l < stage_count(); ++l) theta_dot += by_time(i, l) * theta_of(l, node);
                    derivative += tangent_map_derivative(theta_of(i, node), theta_dot);
                }
                return derivative * inverse;
            };
            NodeLinearization& one = linearizations[node];
            one.placement = j == k ? 1.0 : 0.0;
            one.rate = by_time(j, k);
            one.acceleration = acceleration;
            one.d_omega = d_omega(j);
            one.d_alpha.setZero();
            for (int i = 0; i < stage_count(); ++i) one.d_alpha += by_time(j, i) * d_omega(i);
        }
    });
}

void CoupledStages::end_step(State& state, const Stage& step, const ThreadTeam& team) const {
    state.trial_time = step.end_time;
    if (ends_with_stage_) state.trial = state.stage_motions.back();
    team.for_each_range(state.previous.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            carry(state, step.time_step, i);
            if (ends_with_stage_) continue;
            const NodeMotion& previous = state.previous[i];
            NodeMotion& trial = state.trial[i];
            Vec3 r = previous.r, theta = Vec3::Zero();
            trial.v = previous.v;
            trial.omega = previous.omega;
            for (Eigen::Index j = 0; j < end_.size(); ++j) {
                const NodeMotion& motion = state.stage_motions[static_cast<std::size_t>(j)][i];
                r += end_[j] * (motion.r - previous.r);
                theta += end_[j] * motion.theta;
                trial.v += end_[j] * (motion.v - previous.v);
                trial.omega += end_[j] * (motion.omega - previous.omega);
            }
            place(previous, r, theta, trial);
        }
    });
}

CoupledStages::Defect CoupledStages::compute_defect(const State& state,
                                                    double time_step,
                                                    std::size_t node) const {
    const NodeMotion& previous = state.previous[node];
    Defect defect;
    defect.rates << previous.v, previous.omega;
    defect.accelerations << previous.a, previous.alpha;
    for (Eigen::Index j = 0; j < error_weights_.size(); ++j) {
        const NodeMotion& motion = state.stage_motions[static_cast<std::size_t>(j)][node];
        const double weight = error_weights_[j] / time_step;
        defect.rates.head<3>() += weight * (motion.r - previous.r);
        defect.rates.tail<3>() += weight * motion.theta;
        defect.accelerations.head<3>() += weight * (motion.v - previous.v);
        defect.accelerations.tail<3>() += weight * (motion.omega - previous.omega);
    }
    return defect;
}

void CoupledStages::place_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const NodeMotion& previous = state.previous[i];
        place(previous,
              previous.r + stage.time_step * previous.v,
              stage.time_step * previous.omega,
              state.trial[i]);
    }
}

void CoupledStages::update_nodes(State&, const Stage&, NodeRange) const {
    assert(false);  // rates of a stage depend on all stages: update_stages
}

void CoupledStages::linearize_nodes(const State&,
                                    const Stage& stage,
                                    NodeRange nodes,
                                    std::vector<NodeLinearization>& linearizations) const {
    const double factor = typical_factor() / stage.time_step;
    const Mat3 d_omega = factor * Mat3::Identity();
    for (std::size_t i = nodes.first; i < nodes.last; ++i)
        linearizations[i] = {1.0, factor, factor * factor, d_omega, factor * d_omega};
}

}  // namespace gxrod
