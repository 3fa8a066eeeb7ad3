#include "solvers/divergence.hpp"

#include <cmath>
#include <limits>

#include "assembly/system_measures.hpp"
#include "linear/eigen/eigenvalue_count.hpp"
#include "linear/eigen/lowest_pairs.hpp"
#include "linear/eigen/pencil.hpp"

namespace gxrod {

namespace {

constexpr double rounding = 100.0 * std::numeric_limits<double>::epsilon();

std::vector<double> compute_stiffness(const System& system, double time, State& state) {
    // Without them the tangent is the consistent one.
    std::vector<Vec6> resultants;
    resultants.swap(state.resultants);
    std::vector<double> values;
    const NodeLinearization placement{.placement = 1.0};
    system.compute_tangent(
        state, time, std::vector<NodeLinearization>(state.trial.size(), placement), values);
    resultants.swap(state.resultants);
    return values;
}

void raise_diagonal(const SparsePattern& pattern, std::vector<double>& values) {
    for (std::int64_t i = 0; i < pattern.size(); ++i) {
        double& entry = values[static_cast<std::size_t>(pattern.slot(i, i))];
        entry += rounding * std::abs(entry);
    }
}

// By which factor powers of (K + σ drag)⁻¹ σ drag lengthen x in the end, each time; x becomes what is left.
double find_growth(const SparsePattern& pattern,
                   const std::vector<double>& values,
                   double sigma,
                   const std::vector<double>& drag,
                   EigenvalueCount& shifted,
                   Eigen::VectorXd& x) {
    constexpr int most = 400;
    constexpr int lap = 40;  // of shapes that swing, over several swings
    constexpr double steady = 1e-7;
    shifted.factorize(values, sigma, drag);
    Eigen::VectorXd image = multiply(pattern, drag, x);
    const auto scale = [&] {
        const double length = std::sqrt(x.dot(image));
        x /= length;
        image /= length;
        return length;
    };
    scale();
    double growth = 0.0;
    for (int i = 0; i < most; i += lap) {
        const double before = growth;
        growth = 0.0;
        for (int k = 0; k < lap; ++k) {
            x = sigma * image;
            shifted.solver().solve(x);
            image = multiply(pattern, drag, x);
            const double length = scale();
            if (!(length > 0.0) || !std::isfinite(length)) return 0.0;
            growth += std::log(length) / lap;
        }
        if (i > 0 && std::abs(growth - before) < steady) break;
    }
    return std::exp(growth);
}

}  // namespace

double measure_load_stiffness(const System& system,
                              double time,
                              const SolverWorkspace& workspace,
                              const State& state) {
    const double length = system.length_scale();
    double sum = 0.0;
    for (const std::vector<Vec6>& forces :
         {SystemMeasures(system).compute_load_forces(state, time), workspace.residual.nodal}) {
        for (const Vec6& force : forces) sum += force.head<3>().norm() + force.tail<3>().norm() / length;
    }
    return sum / length;
}

bool is_softer_than(double bound, const System& system, double time, const PseudoDrag& drag, State& state) {
    const SparsePattern& pattern = system.pattern();
    std::vector<double> values = make_symmetric(pattern, compute_stiffness(system, time, state));
    raise_diagonal(pattern, values);
    EigenvalueCount counter(pattern, system.team(), system.equations().attached_count());
    return counter.count(values, -bound, drag.make_matrix()) != 0;
}

std::optional<Divergence> find_divergence(
    const System& system, double time, const PseudoDrag& drag, double least, State& state) {
    const SparsePattern& pattern = system.pattern();
    const std::int64_t multipliers = system.equations().attached_count();
    const std::vector<double> values = compute_stiffness(system, time, state);
    std::vector<double> symmetric = make_symmetric(pattern, values);
    raise_diagonal(pattern, symmetric);
    const std::vector<double> drag_values = drag.make_matrix();
    EigenvalueCount counter(pattern, system.team(), multipliers);
    if (counter.count(symmetric, least, drag_values) == 0) return std::nullopt;
    const std::optional<LowestPairs> lowest =
        find_lowest_pairs(pattern, symmetric, drag_values, 1, {}, system.team(), multipliers);
    if (!lowest || lowest->values.size() == 0 || lowest->values[0] >= -least) return std::nullopt;
    const double softest = -lowest->values[0];
    Divergence found{softest, softest, lowest->vectors.col(0)};
    const double growth = find_growth(pattern, values, 2.0 * softest, drag_values, counter, found.shape);
    found.rate = 2.0 * softest * (1.0 - 1.0 / growth);
    if (!(found.rate > least)) return std::nullopt;
    return found;
}

}  // namespace gxrod
