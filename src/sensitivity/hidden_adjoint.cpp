#include "sensitivity/hidden_adjoint.hpp"

#include <algorithm>
#include <array>

#include "assembly/scatter.hpp"
#include "integrators/newmark.hpp"
#include "linear/eigen/pencil.hpp"
#include "linear/transposed_values.hpp"
#include "sensitivity/sensitivity_error.hpp"
#include "solvers/hidden_constraints.hpp"
#include "solvers/newton_steps.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

void check(const EquilibriumReport& report, const char* what) {
    if (!report.converged())
        throw SensitivityError(std::string("a step cannot be gone back through: ") + what +
                               " cannot be found anew; take a difference of whole runs");
}

std::vector<Vec6> list_increments(const System& system, const Eigen::VectorXd& vector) {
    std::vector<Vec6> nodal(system.equations().node_count());
    for (std::size_t i = 0; i < nodal.size(); ++i)
        nodal[i] = system.equations().increment_of(static_cast<int>(i), vector);
    return nodal;
}

RowNumbers scale(const RowNumbers& a, const RowNumbers& b) {
    RowNumbers product(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) product[i] = a[i] * b[i];
    return product;
}

// Where a function is asked for its derivative at zero, and the factors of its values: an error of order h⁴.
struct Differences {
    std::array<double, 4> places, slopes;
};

Differences make_differences(double h) {
    return {{h, -h, 2.0 * h, -2.0 * h},
            {2.0 / (3.0 * h), -2.0 / (3.0 * h), -1.0 / (12.0 * h), 1.0 / (12.0 * h)}};
}

}  // namespace

HiddenAdjoint::HiddenAdjoint(const System& system,
                             const Integrator& integrator,
                             const NewtonSettings& newton,
                             LinearSolverKind linear_solver,
                             double part)
    : system_(system),
      integrator_(integrator),
      newton_(newton),
      forward_(system, linear_solver),
      masses_(system, linear_solver),
      part_(part) {}

ConstraintRequest HiddenAdjoint::of_velocities(const Stage& step) const {
    return {ConstraintLevel::velocity, {step.step_time, step.time_step}, time_scale_};
}

ConstraintRequest HiddenAdjoint::of_accelerations(const Stage& step) {
    return {ConstraintLevel::acceleration, {step.step_time, step.time_step}};
}

// As TangentLinearStep.
void HiddenAdjoint::repeat(const Stage& step, State& state, const std::function<void()>& hold_laws) {
    const TimeSpan span{step.step_time, step.time_step};
    EquilibriumReport report = solve_equilibrium({system_, integrator_, newton_}, step, forward_, state);
    check(report, "its equilibrium");
    state.resultants.clear();
    hold_laws();
    equilibrium_ = state;
    integrator_.linearize(state, step, linearizations_);
    system_.compute_tangent(state, step.end_time, linearizations_, values_);
    forward_.values = values_;
    if (!factorize(system_, forward_, report)) check(report, "the inverse of its tangent");
    time_scale_ = find_time_scale(system_, state);
    projection_ = project_velocities(system_, step.end_time, span, forward_, state, report);
    check(report, "velocities that fit the joints");
    moves_ = list_increments(system_, projection_);
    check(solve_accelerations(system_, step.end_time, span, forward_, state), "its accelerations");
    mass_values_ = forward_.values;
}

void HiddenAdjoint::transpose(const Stage& step,
                              const State& end,
                              TransposedProducts& products,
                              SolverWorkspace& transposed,
                              MotionGradient& gradient,
                              MotionGradient& before) {
    transpose_accelerations(step, end, products, gradient);
    transpose_projection(step, end, products, transposed, gradient);
    transpose_matrix(step, products, gradient, before);
}

// (G17): accelerations before they are found anew do not count.
void HiddenAdjoint::transpose_accelerations(const Stage& step,
                                            const State& end,
                                            TransposedProducts& products,
                                            MotionGradient& gradient) {
    std::vector<Vec6> nodal(gradient.nodes.size());
    for (std::size_t i = 0; i < nodal.size(); ++i) {
        nodal[i] << gradient.nodes[i].a, gradient.nodes[i].alpha;
        gradient.nodes[i].a.setZero();
        gradient.nodes[i].alpha.setZero();
    }
    masses_.values = transpose_values(system_.pattern(), mass_values_);
    EquilibriumReport report;
    if (!factorize(system_, masses_, report)) check(report, "the inverse of its masses");
    of_accelerations_ = gather(nodal, system_.equations(), system_.team());
    solve_transposed(system_, mass_values_, masses_, of_accelerations_);
    const std::vector<Vec6> eta = list_increments(system_, of_accelerations_);
    const RowNumbers p = scale(list_scales(system_, mass_values_), take_rows(system_, of_accelerations_));
    const ConstraintRequest request = of_accelerations(step);
    const std::vector<Vec6> by_place =
        products.compute(end, step.end_time, request, {.placement = 1.0}, eta, p);
    const std::vector<Vec6> by_rate =
        products.compute(end, step.end_time, request, {.rate = 1.0, .d_omega = Mat3::Identity()}, eta, p);
    for (std::size_t i = 0; i < nodal.size(); ++i) {
        MotionGradient::OfNode& node = gradient.nodes[i];
        node.r -= by_place[i].head<3>();
        node.phi -= by_place[i].tail<3>();
        node.v -= by_rate[i].head<3>();
        node.omega -= by_rate[i].tail<3>();
    }
}

// (G18): velocities v + x̂/τ with K x̂ = Gᵀν and G (v + x̂/τ) + ∂Φ/∂t = 0. Of Φ̇ the derivative by the placement
// is half that of Φ̈ by velocities, and for spins (Gᵀp) × ω/2.
void HiddenAdjoint::transpose_projection(const Stage& step,
                                         const State& end,
                                         TransposedProducts& products,
                                         SolverWorkspace& transposed,
                                         MotionGradient& gradient) {
    const std::size_t count = gradient.nodes.size();
    std::vector<Vec6> nodal(count);
    for (std::size_t i = 0; i < count; ++i)
        nodal[i] << gradient.nodes[i].v / time_scale_, gradient.nodes[i].omega / time_scale_;
    of_projection_ = gather(nodal, system_.equations(), system_.team());
    solve_transposed(system_, values_, transposed, of_projection_);
    xi_ = list_increments(system_, of_projection_);
    const RowNumbers p = scale(list_scales(system_, values_), take_rows(system_, of_projection_));
    const std::vector<Vec6> by_rate = products.compute(end,
                                                       step.end_time,
                                                       of_accelerations(step),
                                                       {.rate = 1.0, .d_omega = Mat3::Identity()},
                                                       std::vector<Vec6>(count, Vec6::Zero()),
                                                       p);
    for (std::size_t i = 0; i < count; ++i) {
        MotionGradient::OfNode& node = gradient.nodes[i];
        const Vec6 force = time_scale_ * products.forces()[i];
        const Vec6 changes = -0.5 * time_scale_ * by_rate[i];
        node.r += changes.head<3>();
        node.phi += changes.tail<3>() + 0.5 * force.tail<3>().cross(end.trial[i].omega);
        node.v += force.head<3>();
        node.omega += force.tail<3>();
    }
}

// The equilibrium moved along x̂ and ν.
State HiddenAdjoint::move_along(double amount) const {
    State moved = equilibrium_;
    std::vector<Vec6> increments = moves_;
    for (Vec6& one : increments) one *= amount;
    system_.joints().advance_multipliers(increments, amount * projection_, values_, moved);
    for (std::size_t i = 0; i < increments.size(); ++i) {
        const Vec3 way = increments[i].head<3>(), spin = increments[i].tail<3>();
        NodeMotion& motion = moved.trial[i];
        apply_spin(moved.previous[i], way, spin, motion);
        motion.v += linearizations_[i].rate * way;
        motion.a += linearizations_[i].acceleration * way;
        motion.omega += linearizations_[i].d_omega * spin;
        motion.alpha += linearizations_[i].d_alpha * spin;
    }
    return moved;
}

double HiddenAdjoint::find_part() const {
    double size = 0.0;
    for (const Vec6& move : moves_)
        size = std::max({size, move.head<3>().norm() / system_.length_scale(), move.tail<3>().norm()});
    constexpr double none = 1e-16;
    return size < none ? 0.0 : part_ / size;
}

// −η · R at the end, and the derivative of −ξ · R along x̂.
void HiddenAdjoint::subtract_by_memory(const Stage& step,
                                       const State& end,
                                       const RodMemory& memory,
                                       MemoryGradient& memory_before,
                                       MotionGradient& before) const {
    memory.add_by_memory(
        end, step.end_time, list_increments(system_, of_accelerations_), {}, memory_before, before);
    const double h = find_part();
    if (h == 0.0) return;
    const auto [places, slopes] = make_differences(h);
    for (std::size_t k = 0; k < places.size(); ++k) {
        std::vector<Vec6> xi = xi_;
        for (Vec6& one : xi) one *= slopes[k];
        memory.add_by_memory(move_along(places[k]), step.end_time, xi, {}, memory_before, before);
    }
}

// (G19): ξ · (K x̂ − Gᵀν) is the derivative of ξ · R along x̂ and ν, so its gradient is that of the gradient of
// ξ · R, and what the directions change with the placement: spins do not commute.
void HiddenAdjoint::transpose_matrix(const Stage& step,
                                     TransposedProducts& products,
                                     MotionGradient& gradient,
                                     MotionGradient& before) {
    by_multipliers_.assign(list_scales(system_, values_).size(), 0.0);
    const double h = find_part();
    if (h == 0.0) return;
    const std::size_t count = gradient.nodes.size();
    const RowNumbers no_rows(by_multipliers_.size(), 0.0);
    std::vector<Vec6> by_rates(count, Vec6::Zero()), by_accelerations(count, Vec6::Zero());
    // Of the derivative, and of the value in the middle.
    const auto [places, slopes] = make_differences(h);
    const std::array<double, 4> means{2.0 / 3.0, 2.0 / 3.0, -1.0 / 6.0, -1.0 / 6.0};
    for (std::size_t k = 0; k < places.size(); ++k) {
        const State moved = move_along(places[k]);
        const auto compute = [&](const NodeLinearization& by) {
            return products.compute(moved, step.end_time, {}, by, xi_, no_rows);
        };
        const std::vector<Vec6> by_place = compute({.placement = 1.0});
        for (std::size_t row = 0; row < no_rows.size(); ++row)
            by_multipliers_[row] += slopes[k] * products.gradient()[row];
        const std::vector<Vec6> by_rate = compute({.rate = 1.0, .d_omega = Mat3::Identity()});
        const std::vector<Vec6> by_acceleration = compute({.acceleration = 1.0, .d_alpha = Mat3::Identity()});
        for (std::size_t i = 0; i < count; ++i) {
            MotionGradient::OfNode& node = gradient.nodes[i];
            node.r -= slopes[k] * by_place[i].head<3>();
            node.phi -= slopes[k] * by_place[i].tail<3>() +
                        means[k] * by_place[i].tail<3>().cross(moves_[i].tail<3>());
            node.v -= slopes[k] * by_rate[i].head<3>();
            node.omega -= slopes[k] * by_rate[i].tail<3>();
            node.a -= slopes[k] * by_acceleration[i].head<3>();
            node.alpha -= slopes[k] * by_acceleration[i].tail<3>();
            by_rates[i] += means[k] * by_rate[i];
            by_accelerations[i] += means[k] * by_acceleration[i];
        }
    }
    transpose_linearization(step, by_rates, by_accelerations, gradient, before);
}

// The rates along x̂ are those of the scheme's linearization, which depends on θ, ω and α, node by node.
void HiddenAdjoint::transpose_linearization(const Stage& step,
                                            const std::vector<Vec6>& by_rates,
                                            const std::vector<Vec6>& by_accelerations,
                                            MotionGradient& gradient,
                                            MotionGradient& before) const {
    const std::size_t count = gradient.nodes.size();
    const auto [places, slopes] = make_differences(1e-3);
    std::vector<NodeLinearization> linearizations;
    std::vector<Vec3> by_theta(count, Vec3::Zero());
    State moved = equilibrium_;
    for (Vec3 NodeMotion::*member : {&NodeMotion::theta, &NodeMotion::omega, &NodeMotion::alpha}) {
        for (Eigen::Index k = 0; k < 3; ++k) {
            for (std::size_t point = 0; point < places.size(); ++point) {
                for (std::size_t i = 0; i < count; ++i)
                    (moved.trial[i].*member)[k] = (equilibrium_.trial[i].*member)[k] + places[point];
                integrator_.linearize(moved, step, linearizations);
                for (std::size_t i = 0; i < count; ++i) {
                    const Vec3 spin = moves_[i].tail<3>();
                    const double change =
                        slopes[point] * (by_rates[i].tail<3>().dot(linearizations[i].d_omega * spin) +
                                         by_accelerations[i].tail<3>().dot(linearizations[i].d_alpha * spin));
                    if (member == &NodeMotion::theta) by_theta[i][k] -= change;
                    if (member == &NodeMotion::omega) gradient.nodes[i].omega[k] -= change;
                    if (member == &NodeMotion::alpha) gradient.nodes[i].alpha[k] -= change;
                }
            }
            for (std::size_t i = 0; i < count; ++i)
                (moved.trial[i].*member)[k] = (equilibrium_.trial[i].*member)[k];
        }
    }
    for (std::size_t i = 0; i < count; ++i)
        transpose_turn(equilibrium_.trial[i].theta, by_theta[i], gradient.nodes[i], before.nodes[i]);
}

double HiddenAdjoint::weigh(const Stage& step, const System& system, const State& end, State& state) {
    std::vector<NodeLinearization> linearizations;
    std::vector<double> values;
    integrator_.linearize(state, step, linearizations);
    system.compute_tangent(state, step.end_time, linearizations, values);
    Eigen::VectorXd residual = multiply(system.pattern(), values, projection_);
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        NodeMotion& motion = state.trial[i];
        motion.v += moves_[i].head<3>() / time_scale_;
        motion.omega += moves_[i].tail<3>() / time_scale_;
        motion.a = end.trial[i].a;
        motion.alpha = end.trial[i].alpha;
    }
    system.joints().compute_rows(state, step.end_time, of_velocities(step), residual_.rows);
    system.joints().set_rows(residual_.rows, values_, residual);
    double sum = -of_projection_.dot(residual);
    state.joints_trial = end.joints_trial;
    system.supports().set_rates(step.end_time, {step.step_time, step.time_step}, state.trial);
    system.compute_residual(state, step.end_time, residual_, of_accelerations(step));
    sum -= of_accelerations_.dot(gather_residual(system, residual_, mass_values_));
    return sum;
}

}  // namespace gxrod
