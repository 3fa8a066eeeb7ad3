#include "sensitivity/tangent_linear_step.hpp"

#include <string>

#include "linear/eigen/pencil.hpp"
#include "rotation/rotation_map.hpp"
#include "sensitivity/sensitivity_error.hpp"
#include "solvers/hidden_constraints.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/trial_rates.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

[[noreturn]] void fail(const std::string& what) {
    throw SensitivityError("the derivative of a step cannot be found: " + what +
                           "; take a difference of whole runs");
}

void check(const EquilibriumReport& report, const char* what) {
    if (!report.converged()) fail("Newton's method does not find " + std::string(what) + " anew");
}

}  // namespace

TangentLinearStep::TangentLinearStep(const System& base,
                                     const Integrator& integrator,
                                     const NewtonSettings& newton,
                                     LinearSolverKind linear_solver)
    : centre_(base.model(), 0.0),
      base_system_(centre_.system),
      integrator_(integrator),
      newton_(newton),
      workspace_(base_system_, linear_solver),
      has_hidden_constraints_(gxrod::has_hidden_constraints(base) && !integrator.is_static()) {}

void TangentLinearStep::advance(const Stage& first_stage,
                                const State& before,
                                const State& after,
                                std::span<VariedSystem* const> given) {
    base_ = centre_.state = before;
    undo_trial(base_);
    base_system_.forget_loads();
    memory_before_ = base_.memory;
    std::vector<VariedSystem*> varied(given.begin(), given.end());
    varied.push_back(&centre_);
    for (VariedSystem* one : varied) {
        undo_trial(one->state);
        one->memory_before = one->state.memory;
    }
    // A step that is committed turns the multipliers of sleeves into the axes of its end.
    const bool is_known =
        integrator_.stage_count() == 1 && !has_hidden_constraints_ && base_system_.joints().empty();
    Stage stage = first_stage;
    for (stage.index = 0; stage.index < integrator_.stage_count(); ++stage.index) {
        release();
        if (integrator_.is_explicit()) {
            solve_stage_explicitly(stage, varied);
        } else {
            if (is_known) {
                integrator_.begin_stage(base_, stage);
                base_.trial = after.previous;
                base_.joints_trial = after.joints_previous;
                base_.carried_trial = after.carried_previous;
                for (std::size_t i = 0; i < base_.trial.size(); ++i)
                    base_.trial[i].theta = log(base_.trial[i].Lambda * base_.previous[i].Lambda.conjugate());
                if (is_settling_) update_trial_rates(base_system_, integrator_, stage, base_);
            } else {
                check(solve_equilibrium({base_system_, integrator_, newton_}, stage, workspace_, base_),
                      "its equilibrium");
            }
            hold(integrator_.stage_time(stage), varied);
            solve_stage(stage, varied);
        }
        integrator_.end_stage(base_, stage);
        for (VariedSystem* one : varied) integrator_.end_stage(one->state, stage);
    }
    if (has_hidden_constraints_ && !integrator_.is_explicit()) {
        const TimeSpan step{stage.step_time, stage.time_step};
        meet_velocities(stage.end_time, step, varied);
        find_accelerations(stage.end_time, step, varied);
    }
    for (VariedSystem* one : varied) {
        one->ended = one->state;
        one->system.commit(one->state, after.time);
    }
}

void TangentLinearStep::release() {
    centre_.held.release();
    base_.memory = memory_before_;
}

void TangentLinearStep::hold(double time, std::span<VariedSystem* const> varied) {
    if (centre_.held.has_kinks()) {
        centre_.held.note();
        base_system_.compute_residual(base_, time, workspace_.residual);
        pieces_ = centre_.held.pieces();
    }
    const HeldFriction friction(base_system_, base_, time);
    friction.move(base_);
    for (VariedSystem* one : varied) {
        one->state.memory = one->memory_before;
        friction.move(one->state);
        one->held.hold(pieces_);
    }
}

void TangentLinearStep::settle(const Stage& stage,
                               const State& before,
                               const State& after,
                               std::span<VariedSystem* const> varied) {
    is_settling_ = true;
    advance(stage, before, after, varied);
    is_settling_ = false;
    for (VariedSystem* one : varied) {
        for (std::vector<NodeMotion>* motions : {&one->state.previous, &one->state.trial}) {
            for (NodeMotion& motion : *motions) {
                motion.v.setZero();
                motion.omega.setZero();
            }
        }
    }
}

// (G2)
void TangentLinearStep::solve_stage(const Stage& stage, std::span<VariedSystem* const> varied) {
    base_.resultants.clear();  // the consistent tangent
    compute_matrix(stage, base_system_, base_, workspace_.values);
    EquilibriumReport report;
    if (!factorize(base_system_, workspace_, report)) fail("the tangent is singular");
    const bool is_last = stage.index + 1 == integrator_.stage_count();
    for (VariedSystem* one : varied) {
        follow_equilibrium(stage, *one);
        if (is_last && has_hidden_constraints_) compute_matrix(stage, one->system, one->state, one->values);
    }
}

void TangentLinearStep::compute_matrix(const Stage& stage,
                                       const System& system,
                                       const State& state,
                                       std::vector<double>& values) {
    integrator_.linearize(state, stage, workspace_.linearizations);
    ConstraintRequest request = find_request(base_system_, integrator_, stage);
    if (request.level != ConstraintLevel::position)
        request.factor = 1.0 / workspace_.linearizations.front().acceleration;
    system.compute_tangent(state, integrator_.stage_time(stage), workspace_.linearizations, values, request);
}

// Where the base is, but for what supports hold, which is where the varied model has it. All else is moved by
// the mean of what that changes, so that a model that is moved as a whole is not strained.
void TangentLinearStep::place_next_to_base(double time, VariedSystem& varied) const {
    State& state = varied.state;
    const Supports& supports = varied.system.supports();
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        NodeMotion& trial = state.trial[i];
        trial.r = base_.trial[i].r;
        trial.Lambda = base_.trial[i].Lambda;
        trial.theta = log(trial.Lambda * state.previous[i].Lambda.conjugate());
    }
    const std::vector<Support>& all = varied.system.model().supports;
    for (const Support& support : all) {
        const auto node = static_cast<std::size_t>(support.node);
        const NodeMotion& from = state.previous[node];
        const auto still = [&](const Vec3& change, std::size_t first) {
            Vec3 own = supports.axes(support.node).transpose() * change;
            for (std::size_t i = 0; i < 3; ++i) {
                if (supports.held(support.node)[first + i]) own[static_cast<Eigen::Index>(i)] = 0.0;
            }
            return Vec3(supports.axes(support.node) * own);
        };
        const HeldComponents& held = supports.held(support.node);
        const Vec3 r = from.r + still(state.trial[node].r - from.r, 0);
        // The axis about which a node can turn is held, where a single one is left.
        const bool is_hinged = held[3] + held[4] + held[5] >= 2;
        place(from,
              r,
              is_hinged ? still(state.trial[node].theta, 3) : state.trial[node].theta,
              state.trial[node]);
    }
    supports.place(time, state);
    Vec3 shift = Vec3::Zero();
    for (const Support& support : all) {
        const auto node = static_cast<std::size_t>(support.node);
        shift += (state.trial[node].r - base_.trial[node].r) / static_cast<double>(all.size());
    }
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        const auto node = static_cast<int>(i);
        const HeldComponents& held = supports.held(node);
        Vec3 own = supports.axes(node).transpose() * shift;
        for (int k = 0; k < 3; ++k) {
            if (held[static_cast<std::size_t>(k)]) own[k] = 0.0;
        }
        state.trial[i].r += supports.axes(node) * own;
    }
}

void TangentLinearStep::follow_equilibrium(const Stage& stage, VariedSystem& varied) {
    State& state = varied.state;
    const System& system = varied.system;
    integrator_.begin_stage(state, stage);
    const double time = integrator_.stage_time(stage);
    place_next_to_base(time, varied);
    for (std::size_t i = 0; i < state.joints_trial.size(); ++i)
        state.joints_trial[i].multipliers = base_.joints_trial[i].multipliers;
    update_trial_rates(system, integrator_, stage, state);

    ConstraintRequest request = find_request(base_system_, integrator_, stage);
    if (request.level != ConstraintLevel::position)
        request.factor = 1.0 / workspace_.linearizations.front().acceleration;
    for (int i = 0; i < count_iterations(request); ++i) {
        system.compute_residual(state, time, workspace_.residual, request);
        iterate(system, state);
        update_trial_rates(system, integrator_, stage, state);
    }
}

int TangentLinearStep::count_iterations(const ConstraintRequest& request) const {
    if (base_system_.joints().empty() && !centre_.held.has_kinks()) return 1;
    return request.level == ConstraintLevel::position && !centre_.held.has_kinks() ? 2 : 3;
}

// Of the residual in the workspace.
void TangentLinearStep::iterate(const System& system, State& state) {
    const Eigen::VectorXd residual = gather_residual(system, workspace_.residual, workspace_.values);
    EquilibriumReport report;
    if (!solve_increment(system, residual, workspace_, report)) fail("a solution is not finite");
    workspace_.increments.resize(state.trial.size());
    for (std::size_t i = 0; i < state.trial.size(); ++i)
        workspace_.increments[i] = system.equations().increment_of(static_cast<int>(i), workspace_.vector);
    system.joints().advance_multipliers(workspace_.increments, workspace_.vector, workspace_.values, state);
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        const Vec6& increment = workspace_.increments[i];
        apply_spin(state.previous[i], increment.head<3>(), increment.tail<3>(), state.trial[i]);
    }
}

void TangentLinearStep::solve_stage_explicitly(const Stage& stage, std::span<VariedSystem* const> varied) {
    const double time = integrator_.stage_time(stage);
    const TimeSpan step{stage.step_time, stage.time_step};
    integrator_.begin_stage(base_, stage);
    base_system_.supports().place(time, base_);
    for (VariedSystem* one : varied) {
        integrator_.begin_stage(one->state, stage);
        one->system.supports().place(time, one->state);
    }
    if (stage.index + 1 == integrator_.stage_count() && has_hidden_constraints_) {
        meet_positions(time, varied);
        meet_velocities(time, step, varied);
    }
    find_accelerations(time, step, varied);
}

void TangentLinearStep::find_accelerations(double time,
                                           const TimeSpan& step,
                                           std::span<VariedSystem* const> varied) {
    release();
    check(solve_accelerations(base_system_, time, step, workspace_, base_), "its accelerations");
    hold(time, varied);
    const ConstraintRequest request{ConstraintLevel::acceleration, step};
    for (VariedSystem* one : varied) {
        follow_accelerations(time, step, *one);
        if (!has_hidden_constraints_ || !integrator_.is_explicit()) continue;
        one->system.compute_tangent(
            one->state, time, mass_linearizations(one->state.trial.size()), one->values, request);
    }
}

void TangentLinearStep::follow_accelerations(double time, const TimeSpan& step, VariedSystem& varied) {
    State& state = varied.state;
    const System& system = varied.system;
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        state.trial[i].a = base_.trial[i].a;
        state.trial[i].alpha = base_.trial[i].alpha;
    }
    for (std::size_t i = 0; i < state.joints_trial.size(); ++i)
        state.joints_trial[i].multipliers = base_.joints_trial[i].multipliers;
    system.supports().set_rates(time, step, state.trial);
    EquilibriumReport report;
    for (int i = 0; i <= count_corrections(base_system_); ++i) {
        system.compute_residual(state, time, workspace_.residual, {ConstraintLevel::acceleration, step});
        const Eigen::VectorXd residual = gather_residual(system, workspace_.residual, workspace_.values);
        if (!solve_increment(system, residual, workspace_, report)) fail("a solution is not finite");
        add_accelerations(system, workspace_, state);
    }
}

template <class ComputeRows, class Move>
void TangentLinearStep::follow_projection(const Eigen::VectorXd& total,
                                          const VariedSystem& varied,
                                          const ComputeRows& compute_rows,
                                          const Move& move) {
    const System& system = varied.system;
    const auto move_all = [&](const Eigen::VectorXd& solution) {
        for (std::size_t node = 0; node < varied.state.trial.size(); ++node)
            move(node, system.equations().increment_of(static_cast<int>(node), solution));
    };
    Eigen::VectorXd solution = total;
    move_all(solution);
    constexpr int iterations = 2;  // the second for what the regularization of JointAssembly leaves
    EquilibriumReport report;
    for (int i = 0; i < iterations; ++i) {
        Eigen::VectorXd residual = multiply(system.pattern(), varied.values, solution);
        compute_rows(workspace_.residual.rows);
        system.joints().set_rows(workspace_.residual.rows, workspace_.values, residual);
        if (!solve_increment(system, residual, workspace_, report)) fail("a solution is not finite");
        solution += workspace_.vector;
        move_all(workspace_.vector);
    }
}

void TangentLinearStep::meet_velocities(double time,
                                        const TimeSpan& step,
                                        std::span<VariedSystem* const> varied) {
    // The base's own, of the velocities before they are projected.
    const double time_scale = find_time_scale(base_system_, base_);
    EquilibriumReport report;
    Eigen::VectorXd total;
    project_velocities(base_system_, time, step, workspace_, base_, report, &total);
    check(report, "velocities that fit the joints");
    for (VariedSystem* one : varied) {
        follow_projection(
            total,
            *one,
            [&](std::vector<double>& rows) {
                one->system.joints().compute_rows(
                    one->state, time, {ConstraintLevel::velocity, step, time_scale}, rows);
            },
            [&](std::size_t node, const Vec6& increment) {
                one->state.trial[node].v += increment.head<3>() / time_scale;
                one->state.trial[node].omega += increment.tail<3>() / time_scale;
            });
    }
}

void TangentLinearStep::meet_positions(double time, std::span<VariedSystem* const> varied) {
    EquilibriumReport report;
    Eigen::VectorXd total;
    project_positions(base_system_, time, workspace_, base_, report, &total);
    check(report, "positions that fit the joints");
    for (VariedSystem* one : varied) {
        follow_projection(
            total,
            *one,
            [&](std::vector<double>& rows) { one->system.joints().compute_rows(one->state, time, {}, rows); },
            [&](std::size_t node, const Vec6& increment) {
                apply_spin(one->state.previous[node],
                           increment.head<3>(),
                           increment.tail<3>(),
                           one->state.trial[node]);
            });
    }
}

}  // namespace gxrod
