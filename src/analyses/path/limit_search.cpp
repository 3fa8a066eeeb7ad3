#include "analyses/path/limit_search.hpp"

#include <cmath>
#include <limits>

#include "solvers/newton_steps.hpp"
#include "solvers/path/bordered_solve.hpp"
#include "solvers/path/soft_modes.hpp"

namespace gxrod {

namespace {

constexpr double not_found = std::numeric_limits<double>::quiet_NaN();

bool factorize_tangent(PathContext& work, double parameter) {
    compute_consistent_tangent(work.system, work.integrator, parameter, work.workspace, work.state);
    EquilibriumReport report;
    return factorize(work.system, work.workspace, report);
}

// The factorized tangent's shape closest to singular, of unit length; empty if there is none.
Eigen::VectorXd find_kernel(PathContext& work) {
    const FactorizedTangent tangent = factorized_tangent(work.system, work.workspace);
    const SoftModes modes = find_soft_modes(
        tangent.solver, tangent.pattern, tangent.values, work.metric.weights(), 1, work.is_symmetric);
    if (modes.vectors.cols() != 1 || !modes.vectors.allFinite()) return {};
    return modes.vectors.col(0);
}

constexpr double difference = 1e-5;  // of arc length, for derivatives of the test function

// g of [K Wφ; φᵀW 0] (x, g) = (0, 1) at the trial motions: it vanishes where K is singular. NaN if K is just
// that.
double compute_test(PathContext& work, const Eigen::VectorXd& kernel, double parameter) {
    if (!factorize_tangent(work, parameter)) return not_found;
    const Eigen::VectorXd border = work.metric.row({kernel, 0.0}).u;
    const BorderedSolve bordered(*work.workspace.linear_solver,
                                 work.system.pattern(),
                                 work.workspace.values,
                                 {border, border, Eigen::MatrixXd::Zero(1, 1)});
    return bordered.solve_refined({Eigen::VectorXd::Zero(kernel.size()), Eigen::VectorXd::Ones(1)}).y[0];
}

// A small change on the way along limit points.
struct LimitChange {
    PathVector motion;
    double load_factor = 0.0;  // of the limit points
};

// How g changes with that from the last accepted motions on, which the trial motions are afterwards. To both
// sides: stiff elements answer to a straight motion with forces of its square.
double compute_test_slope(PathContext& work, const Eigen::VectorXd& kernel, const LimitChange& change) {
    const double load_factor = *work.limit_load_factor;
    const auto test_at = [&](double side) {
        *work.limit_load_factor = load_factor + side * change.load_factor;
        work.system.forget_loads();
        std::vector<Vec6> movement(work.state.trial.size());
        for (std::size_t i = 0; i < movement.size(); ++i)
            movement[i] = side * work.system.equations().increment_of(static_cast<int>(i), change.motion.u);
        const double parameter = work.state.time + side * change.motion.load;
        place_trial(work, movement, parameter);
        return compute_test(work, kernel, parameter);
    };
    const double slope = 0.5 * (test_at(1.0) - test_at(-1.0));
    undo_trial(work.state);
    *work.limit_load_factor = load_factor;
    work.system.forget_loads();
    return slope;
}

// Where the load factor is free and the tangent is to be singular, one amplitude is left once the row is
// satisfied: along the kernel at the last limit point. The test function g is a function of it.
class LimitSearch {
  public:
    LimitSearch(PathContext& work, const PathVector& prediction, const PathVector& row)
        : work_(work), prediction_(prediction), row_(row) {}

    EquilibriumReport solve(PathTrial& trial) {
        constexpr int most_evaluations = 12;
        // Of arc length; the load factor's error is of its square.
        constexpr double settled = 1e-9;
        constexpr double small = 1e-7;
        double last_change = std::numeric_limits<double>::infinity();
        if (!prepare()) return fail(Outcome::singular);
        double amplitude = 0.0;
        double value = evaluate(amplitude);
        for (trial.effort = 1; std::isfinite(value); ++trial.effort) {
            const double change = -value / slope_;
            if (!std::isfinite(change) || std::abs(amplitude + change) > farthest_ ||
                trial.effort == most_evaluations)
                return fail(Outcome::out_of_iterations);
            amplitude += change;
            const double before = value;
            value = evaluate(amplitude);
            // As small as round-off lets it be.
            const bool is_stuck = std::abs(change) <= small && 2.0 * std::abs(change) >= last_change;
            if (std::abs(change) <= settled || is_stuck) break;
            last_change = std::abs(change);
            if (value != before && std::abs(change) > small) slope_ = (value - before) / change;
        }
        if (!std::isfinite(value)) return fail(Outcome::out_of_iterations);
        --trial.effort;  // the first one is the prediction
        finish(trial);
        return report_;
    }

  private:
    // Kernel and slope at the last limit point.
    bool prepare() {
        undo_trial(work_.state);
        if (!factorize_tangent(work_, work_.state.time)) return false;
        kernel_ = find_kernel(work_);
        if (kernel_.size() == 0) return false;
        kernel_row_ = work_.metric.row({kernel_, 0.0});
        slope_ = compute_test_slope(work_, kernel_, {{difference * kernel_, 0.0}}) / difference;
        const double length = work_.metric.norm(prediction_);
        farthest_ = std::max(2.0 * length, 0.05);
        // Along the kernel, but so that the row is still satisfied.
        shape_ = {kernel_, 0.0};
        const double rise = apply_row(prediction_);
        if (rise != 0.0) shape_ = shape_ + (-apply_row(shape_) / rise) * prediction_;
        return true;
    }

    double apply_row(const PathVector& x) const { return row_.u.dot(x.u) + row_.load * x.load; }

    // g at the equilibrium with this amplitude, which the trial motions hold; NaN if there is none.
    double evaluate(double amplitude) {
        PathProblem problem{
            prediction_ + amplitude * shape_, {row_, kernel_row_}, {}, work_.limit_load_factor};
        if (has_solution_) problem.prediction = found_ + (amplitude - amplitude_) * shape_;
        PathSolution solution;
        report_ = solve_path_equilibrium(
            {work_.system, work_.integrator, work_.newton}, problem, work_.workspace, work_.state, solution);
        work_.iterations += report_.iterations;
        if (!report_.converged()) return not_found;
        found_ = {compute_step(work_.system, work_.state), solution.load_factor - work_.state.time};
        amplitude_ = amplitude;
        has_solution_ = true;
        return compute_test(work_, kernel_, solution.load_factor);
    }

    void finish(PathTrial& trial) {
        trial.load_factor = work_.state.time + found_.load;
        trial.step = work_.metric.norm(found_);
        trial.residual = report_.residual;
        trial.pivots = -1;
        if (trial.step > 0.0) trial.direction = (1.0 / trial.step) * found_;
        report_.iterations = work_.iterations;
        report_.negative_pivots = -1;
    }

    EquilibriumReport fail(Outcome outcome) {
        if (report_.converged()) report_.outcome = outcome;
        report_.iterations = work_.iterations;
        *work_.limit_load_factor = load_factor_;
        work_.system.forget_loads();
        return report_;
    }

    PathContext& work_;
    const PathVector& prediction_;
    const PathVector& row_;
    double load_factor_ = *work_.limit_load_factor;  // to return to
    Eigen::VectorXd kernel_;
    PathVector kernel_row_;
    PathVector shape_;
    double slope_ = 0.0;
    double farthest_ = 0.0;
    // The last solution: from the last accepted limit point, at this amplitude.
    bool has_solution_ = false;
    PathVector found_;
    double amplitude_ = 0.0;
    EquilibriumReport report_;
};

}  // namespace

EquilibriumReport solve_limit_step(PathContext& work,
                                   const PathVector& prediction,
                                   const PathVector& row,
                                   PathTrial& trial) {
    return LimitSearch(work, prediction, row).solve(trial);
}

std::optional<Eigen::VectorXd> find_limit_rate(PathContext& work) {
    const System& system = work.system;
    const double parameter = work.state.time;
    if (!factorize_tangent(work, parameter)) return std::nullopt;
    const std::vector<double>& values = work.workspace.values;
    const Eigen::VectorXd of_load =
        compute_other_gradient(system, *work.limit_load_factor, parameter, values, work.state);
    const Eigen::VectorXd of_parameter = compute_load_gradient(system, parameter, values, work.state);
    const Eigen::VectorXd kernel = find_kernel(work);
    if (kernel.size() == 0) return std::nullopt;
    constexpr double least_part = 1e-6;  // of the loads' size: below, the tangent is singular by symmetry
    const double size = std::sqrt(of_load.dot(of_load.cwiseQuotient(work.metric.weights())));
    if (std::abs(kernel.dot(of_load)) <= least_part * size) return std::nullopt;
    const BorderedSolve bordered(*work.workspace.linear_solver,
                                 system.pattern(),
                                 work.workspace.values,
                                 {of_load, work.metric.row({kernel, 0.0}).u, Eigen::MatrixXd::Zero(1, 1)});
    const BorderedVector across = bordered.solve_refined({-of_parameter, Eigen::VectorXd::Zero(1)});
    // How much of the kernel keeps the test function.
    const double length = work.metric.norm(across.x);
    const double part = length > 0.0 ? difference / length : 0.0;
    const double by_kernel = compute_test_slope(work, kernel, {{difference * kernel, 0.0}});
    const double by_rest = compute_test_slope(work, kernel, {{part * across.x, part}, part * across.y[0]});
    Eigen::VectorXd rate = across.x;
    if (part > 0.0) rate -= (by_rest / part) / (by_kernel / difference) * kernel;
    if (!rate.allFinite()) return std::nullopt;
    return rate;
}

}  // namespace gxrod
