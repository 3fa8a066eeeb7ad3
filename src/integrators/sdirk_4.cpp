#include "integrators/sdirk_4.hpp"

#include "rotation/tangent_map.hpp"
#include "state/increment.hpp"

namespace gxrod {

const std::array<std::array<double, Sdirk4::stages>, Sdirk4::stages> Sdirk4::a{{
    {1.0 / 4.0, 0.0, 0.0, 0.0, 0.0},
    {1.0 / 2.0, 1.0 / 4.0, 0.0, 0.0, 0.0},
    {17.0 / 50.0, -1.0 / 25.0, 1.0 / 4.0, 0.0, 0.0},
    {371.0 / 1360.0, -137.0 / 2720.0, 15.0 / 544.0, 1.0 / 4.0, 0.0},
    {25.0 / 24.0, -49.0 / 48.0, 125.0 / 16.0, -85.0 / 12.0, 1.0 / 4.0},
}};

const std::array<double, Sdirk4::stages> Sdirk4::embedded_weights{
    59.0 / 48.0, -17.0 / 96.0, 225.0 / 32.0, -85.0 / 12.0, 0.0};

namespace {

// What a stage takes from the stages before it: the part of r, θ, v and ω that does not depend on its own
// rates.
struct Known {
    Vec3 r, theta, v, omega;
};

Known compute_known(const State& state, const Stage& stage, std::size_t node) {
    const NodeMotion& previous = state.previous[node];
    Known known{previous.r, Vec3::Zero(), previous.v, previous.omega};
    for (int j = 0; j < stage.index; ++j) {
        const StageRates& rates = state.stages[j][node];
        const double weight = stage.time_step * Sdirk4::a[stage.index][j];
        known.r += weight * rates.v;
        known.theta += weight * rates.theta_dot;
        known.v += weight * rates.a;
        known.omega += weight * rates.alpha;
    }
    return known;
}

}  // namespace

// The sums of the rows of a, without their rounding.
double Sdirk4::stage_fraction(int stage) const {
    static constexpr std::array<double, stages> fractions{0.25, 0.75, 0.55, 0.5, 1.0};
    return fractions[stage];
}

void Sdirk4::place_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    // With the rates of the stage before. Accelerations are left out: of stiff parts they say nothing.
    const double h = diagonal * stage.time_step;
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const NodeMotion& previous = state.previous[i];
        const Known known = compute_known(state, stage, i);
        const bool is_first = stage.index == 0;
        const Vec3 v = is_first ? previous.v : state.stages[stage.index - 1][i].v;
        const Vec3 theta_dot = is_first ? previous.omega : state.stages[stage.index - 1][i].theta_dot;
        place(previous, known.r + h * v, known.theta + h * theta_dot, state.trial[i]);
    }
    update_nodes(state, stage, nodes);
}

void Sdirk4::update_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    const double h = diagonal * stage.time_step;
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const Known known = compute_known(state, stage, i);
        NodeMotion& trial = state.trial[i];
        trial.v = (trial.r - known.r) / h;
        trial.a = (trial.v - known.v) / h;
        trial.omega = tangent_map(trial.theta) * ((trial.theta - known.theta) / h);
        trial.alpha = (trial.omega - known.omega) / h;
    }
}

void Sdirk4::linearize_nodes(const State& state,
                             const Stage& stage,
                             NodeRange nodes,
                             std::vector<NodeLinearization>& linearizations) const {
    const double h = diagonal * stage.time_step;
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const Vec3& theta = state.trial[i].theta;
        const Vec3 theta_dot = (theta - compute_known(state, stage, i).theta) / h;
        const Mat3 d_omega =
            tangent_map_derivative(theta, theta_dot) * tangent_map_inverse(theta) + Mat3::Identity() / h;
        linearizations[i] = {1.0, 1.0 / h, 1.0 / (h * h), d_omega, d_omega / h};
    }
}

void Sdirk4::finish_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const NodeMotion& trial = state.trial[i];
        StageRates& rates = state.stages[stage.index][i];
        // Of ω, which a moving support prescribes in addition to θ.
        rates.theta_dot = tangent_map_inverse(trial.theta) * trial.omega;
        rates.v = trial.v;
        rates.a = trial.a;
        rates.alpha = trial.alpha;
    }
}

StepError Sdirk4::estimate_error(const State& state, double time_step, const NodeLengths& lengths) const {
    std::vector<Vec6> placements(state.trial.size(), Vec6::Zero());
    std::vector<Vec6> rates = placements;
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        for (int j = 0; j < stages; ++j) {
            const StageRates& stage = state.stages[j][i];
            const double weight = time_step * (a.back()[j] - embedded_weights[j]);
            placements[i].head<3>() += weight * stage.v;
            placements[i].tail<3>() += weight * stage.theta_dot;
            rates[i].head<3>() += weight * time_step * stage.a;
            rates[i].tail<3>() += weight * time_step * stage.alpha;
        }
    }
    return measure_step_error(placements, rates, lengths);
}

std::vector<double> Sdirk4::power_weights() const {
    std::vector<double> weights{0.0};
    weights.insert(weights.end(), a.back().begin(), a.back().end());
    return weights;
}

}  // namespace gxrod
