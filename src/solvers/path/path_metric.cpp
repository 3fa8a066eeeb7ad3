#include "solvers/path/path_metric.hpp"

#include <cmath>

namespace gxrod {

namespace {

constexpr double length_of_a_radian = 0.2;  // against the model's length

// Of each node: its share of the rods' length, or as much as any other node where there is no rod.
std::vector<double> compute_shares(const Model& model) {
    std::vector<double> shares(model.nodes.size(), 0.0);
    double whole = 0.0;
    for (const Rod& rod : model.rods) {
        for (int e = 0; e < rod.element_count(); ++e) {
            const int first = e * (rod.order + 1);
            const double part = (rod.arc_length[first + rod.order] - rod.arc_length[first]) / rod.order;
            for (int i = 0; i <= rod.order; ++i) {
                const bool is_end = i == 0 || i == rod.order;
                shares[rod.element_nodes[first + i]] += is_end ? 0.5 * part : part;
            }
            whole += rod.order * part;
        }
    }
    for (double& share : shares) {
        share = share > 0.0 ? share / whole : 1.0 / static_cast<double>(shares.size());
    }
    return shares;
}

}  // namespace

PathMetric::PathMetric(const System& system) {
    const std::vector<double> shares = compute_shares(system.model());
    const double length = system.length_scale();
    weights_ = Eigen::VectorXd::Zero(system.equations().count());  // multipliers have none
    for (std::size_t node = 0; node < shares.size(); ++node) {
        const auto numbers = system.equations().of_node(static_cast<int>(node));
        for (int i = 0; i < 6; ++i) {
            if (numbers[i] < 0) continue;
            const double scale = i < 3 ? 1.0 / length : length_of_a_radian;
            weights_[numbers[i]] = shares[node] * scale * scale;
        }
    }
}

void PathMetric::scale_load(const Eigen::VectorXd& rate) {
    const double size = norm(rate);
    load_scale_ = size > 0.0 && std::isfinite(size) ? 1.0 / size : 1.0;
}

PathVector PathMetric::row(const PathVector& x) const {
    return {weights_.cwiseProduct(x.u), x.load / (load_scale_ * load_scale_)};
}

double PathMetric::multiply(const PathVector& x, const PathVector& y) const {
    return multiply(x.u, y.u) + x.load * y.load / (load_scale_ * load_scale_);
}

double PathMetric::norm(const PathVector& x) const { return std::sqrt(multiply(x, x)); }
double PathMetric::norm(const Eigen::VectorXd& x) const { return std::sqrt(multiply(x, x)); }

Eigen::VectorXd compute_step(const System& system, const State& state) {
    std::vector<Vec6> nodal(state.trial.size());
    for (std::size_t i = 0; i < nodal.size(); ++i) {
        nodal[i] << state.trial[i].r - state.previous[i].r, state.trial[i].theta;
    }
    return gather(nodal, system.equations(), system.team());
}

}  // namespace gxrod
