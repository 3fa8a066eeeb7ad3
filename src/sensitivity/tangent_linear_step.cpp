#include "sensitivity/tangent_linear_step.hpp"

#include <algorithm>
#include <string>

#include "assembly/scatter.hpp"
#include "linear/eigen/pencil.hpp"
#include "model/contact.hpp"
#include "rotation/rotation_map.hpp"
#include "sensitivity/sensitivity_error.hpp"
#include "solvers/coupled/coupled_step.hpp"
#include "solvers/hidden_constraints.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/paired_matrix.hpp"
#include "solvers/trial_rates.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

[[noreturn]] void fail(const std::string& what) {
    throw SensitivityError("the derivative of a step cannot be found: " + what +
                           "; take a difference of whole runs");
}

// Forces of contact are not defined where a gap is closed.
void check_gaps(double time, const VariedSystem& varied) {
    const Contacts contacts(varied.system);
    if (contacts.are_possible() && !contacts.describe_overlap(varied.state, time).empty())
        throw ClosedGapError("a small change of the number closes a gap of contact");
}

void check(const EquilibriumReport& report, const char* what) {
    if (!report.converged()) fail("Newton's method does not find " + std::string(what) + " anew");
}

}  // namespace

Eigen::VectorXd take_regularization(const System& system,
                                    const std::vector<double>& values,
                                    const Eigen::VectorXd& vector) {
    Eigen::VectorXd taken = Eigen::VectorXd::Zero(vector.size());
    const std::vector<AttachedUnknowns>& attached = system.joints().attached();
    for (std::size_t i = 0; i < attached.size(); ++i) {
        const std::int64_t first = system.equations().of_attached(i);
        for (std::int64_t row = first; row < first + attached[i].count; ++row)
            taken[row] = values[static_cast<std::size_t>(system.pattern().slot(row, row))] * vector[row];
    }
    return taken;
}

// Where the base is, but for what supports hold, which is where the varied model has it. All else is moved by
// the mean of what that changes, so that a model that is moved as a whole is not strained.
void place_next_to(const State& base, double time, VariedSystem& varied) {
    State& state = varied.state;
    const Supports& supports = varied.system.supports();
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        NodeMotion& trial = state.trial[i];
        trial.r = base.trial[i].r;
        trial.Lambda = base.trial[i].Lambda;
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
    if (Contacts(varied.system).are_possible()) {
        // Obstacles do not move along, and gaps are small.
        state.contact = {};
        Contacts(varied.system).search(state);
        check_gaps(time, varied);
        return;
    }
    Vec3 shift = Vec3::Zero();
    for (const Support& support : all) {
        const auto node = static_cast<std::size_t>(support.node);
        shift += (state.trial[node].r - base.trial[node].r) / static_cast<double>(all.size());
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

TangentLinearStep::TangentLinearStep(const System& base,
                                     const Integrator& integrator,
                                     const NewtonSettings& newton,
                                     LinearSolverKind linear_solver)
    : centre_(base.model(), 0.0),
      base_system_(centre_.system),
      integrator_(integrator),
      newton_(newton),
      contacts_(base_system_),
      workspace_(base_system_, linear_solver),
      has_hidden_constraints_(gxrod::has_hidden_constraints(base) && !integrator.is_static()),
      stops_(base_system_.model()),
      stop_choice_(stops_.empty() ? StopChoice::by_level : StopChoice::as_before) {
    if (integrator.resolves_contact()) resolve_contact(centre_.system);
    if (workspace_.paired) workspace_.paired->solve_directly();
}

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
    if (const CoupledStages* scheme = integrator_.coupled()) {
        solve_together(*scheme, first_stage, varied);
        for (const std::vector<JointState>& joints : base_.stage_joints) check_stops(joints);
        stage.index = integrator_.stage_count();
    }
    for (; stage.index < integrator_.stage_count(); ++stage.index) {
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
                // Accepted accelerations are those without impulses.
                if (is_settling_ || contacts_.are_impulses())
                    update_trial_rates(base_system_, integrator_, stage, base_);
            } else {
                check(solve_equilibrium({base_system_, integrator_, newton_}, stage, workspace_, base_),
                      "its equilibrium");
            }
            place_contact(integrator_.stage_time(stage));
            hold(integrator_.stage_time(stage), varied);
            solve_stage(stage, varied);
        }
        integrator_.end_stage(base_, stage);
        for (VariedSystem* one : varied) integrator_.end_stage(one->state, stage);
    }
    if (has_hidden_constraints_ && !integrator_.is_explicit()) {
        const TimeSpan step{stage.step_time, stage.time_step};
        // As solve_step does.
        if (!stops_.empty()) find_accelerations(stage.end_time, step, varied);
        meet_velocities(stage.end_time, step, varied);
        find_accelerations(stage.end_time, step, varied);
    }
    split_contact(stage, varied);
    commit(after, varied);
}

void TangentLinearStep::commit(const State& after, std::span<VariedSystem* const> varied) {
    for (VariedSystem* one : varied) {
        // What a commit remembers of friction follows from forces.
        if (rubs(one->system.model().contact)) check_gaps(after.time, *one);
        one->ended = one->state;
        one->system.commit(one->state, after.time);
        stops_.copy(one->ended.joints_trial, one->state.joints_previous);
        stops_.copy(one->ended.joints_trial, one->state.joints_trial);
    }
    check_stops(after.joints_previous);
}

void TangentLinearStep::release() {
    centre_.held.release();
    base_.memory = memory_before_;
}

HeldStage TangentLinearStep::find_held(double time) {
    if (centre_.held.has_kinks()) {
        centre_.held.note();
        base_system_.compute_residual(base_, time, workspace_.residual);
    }
    return {centre_.held.pieces(), HeldFriction(base_system_, base_, time)};
}

void TangentLinearStep::hold(const HeldStage& held,
                             const std::vector<double>& memory,
                             HeldModel& model,
                             State& state) const {
    state.memory = memory;
    held.friction.move(state);
    model.hold(held.pieces);
}

void TangentLinearStep::hold(double time, std::span<VariedSystem* const> varied) {
    const HeldStage held = find_held(time);
    pieces_ = held.pieces;
    hold_stops(varied);
    hold(held, memory_before_, centre_.held, base_);
    for (VariedSystem* one : varied) hold(held, one->memory_before, one->held, one->state);
}

// Each stage starts from what was remembered before the step.
void TangentLinearStep::hold_stages(StagesOfStep& stages) {
    held_stages_.clear();
    for (std::size_t j = 0; j < stages.count(); ++j)
        stages.with_stage(j, [&] { held_stages_.push_back(find_held(stages.time_of(j))); });
    stages.prepare = [this](std::size_t j) { hold(held_stages_[j], memory_before_, centre_.held, base_); };
    pieces_ = held_stages_.back().pieces;
}

void TangentLinearStep::hold_stops(std::span<VariedSystem* const> varied) {
    if (stops_.empty()) return;
    check_stops(base_.joints_trial);
    const bool has_rates = !integrator_.is_static() && base_system_.model().has_inertia;
    if (!has_rates && stops_.are_at_limit(base_, base_system_.length_scale()))
        throw KinkError("a joint is at its limit without a force");
    stops_.copy(base_.joints_trial, base_.joints_previous);
    for (VariedSystem* one : varied) stops_.copy(base_.joints_trial, one->state.joints_previous);
}

void TangentLinearStep::check_stops(const std::vector<JointState>& now) const {
    const bool has_rates = !integrator_.is_static() && base_system_.model().has_inertia;
    if (has_rates && !stops_.are_equal(now, base_.joints_previous))
        throw KinkError("a joint becomes taut or slack, or meets or leaves a stop");
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
    linearizations_ = workspace_.linearizations;
    if (workspace_.paired) {
        workspace_.paired->start(contacts_.list_groups(base_));
        workspace_.paired->set_values(
            workspace_.values,
            contacts_.compute_tangents(base_, integrator_.contact_weight(), linearizations_));
        workspace_.is_paired = true;
    }
    EquilibriumReport report;
    const bool is_regular = factorize(base_system_, workspace_, report);
    for (VariedSystem* one : varied) {
        if (is_regular) follow_equilibrium(stage, *one);
    }
    workspace_.is_paired = false;
    if (!is_regular) fail("the tangent is singular");
    if (stage.index + 1 < integrator_.stage_count() || !has_hidden_constraints_) return;
    if (workspace_.paired && !factorize(base_system_, workspace_, report)) fail("the tangent is singular");
    for (VariedSystem* one : varied) {
        check_gaps(integrator_.stage_time(stage), *one);
        compute_matrix(stage, one->system, one->state, one->values);
    }
}

void TangentLinearStep::place_contact(double time) {
    if (!contacts_.are_possible()) return;
    if (base_.contact.drag > 0.0) fail("rods that touch were braked so as not to gain energy");
    base_.contact = {};
    contacts_.search(base_);
    if (!contacts_.are_impulses() || !contacts_.couple_rods()) return;
    // A drag of the step itself is not known anymore, but its force would be missing.
    constexpr double balanced = 1e-5;  // of the largest force of contact
    double largest = 0.0;
    for (const Vec6& force : contacts_.compute_forces(base_, time))
        largest = std::max(largest, force.head<3>().norm());
    if (largest == 0.0) return;
    ConstraintRequest request;
    request.contact_weight = integrator_.contact_weight();
    base_system_.compute_residual(base_, time, workspace_.residual, request);
    std::vector<Vec6> forces_alone = workspace_.residual.nodal;
    for (Vec6& one : forces_alone) one.tail<3>().setZero();
    if (gather(forces_alone, base_system_.equations(), base_system_.team()).lpNorm<Eigen::Infinity>() >
        balanced * largest)
        fail("rods that touch were braked so as not to gain energy");
}

void TangentLinearStep::compute_matrix(const Stage& stage,
                                       const System& system,
                                       const State& state,
                                       std::vector<double>& values) {
    integrator_.linearize(state, stage, workspace_.linearizations);
    ConstraintRequest request = find_request(base_system_, integrator_, stage);
    request.stops = stop_choice_;
    if (request.level != ConstraintLevel::position)
        request.factor = 1.0 / workspace_.linearizations.front().acceleration;
    system.compute_tangent(state, integrator_.stage_time(stage), workspace_.linearizations, values, request);
}

void TangentLinearStep::follow_equilibrium(const Stage& stage, VariedSystem& varied) {
    State& state = varied.state;
    const System& system = varied.system;
    integrator_.begin_stage(state, stage);
    const double time = integrator_.stage_time(stage);
    place_next_to(base_, time, varied);
    for (std::size_t i = 0; i < state.joints_trial.size(); ++i)
        state.joints_trial[i].multipliers = base_.joints_trial[i].multipliers;
    update_trial_rates(system, integrator_, stage, state);

    ConstraintRequest request = find_request(base_system_, integrator_, stage);
    request.stops = stop_choice_;
    if (request.level != ConstraintLevel::position)
        request.factor = 1.0 / linearizations_.front().acceleration;
    const bool refines = is_linear(request);
    constexpr int otherwise = 3;
    for (int i = 0; i < (refines ? 1 : otherwise); ++i) {
        if (i > 0) check_gaps(time, varied);
        system.compute_residual(state, time, workspace_.residual, request);
        iterate(system, state, refines);
        if (advances_rates()) {
            advance_rates(stage, system, state);
        } else {
            update_trial_rates(system, integrator_, stage, state);
        }
    }
}

// Where the scheme carries more than rates, or nothing has any, they are the scheme's own.
bool TangentLinearStep::advances_rates() const {
    return !is_settling_ && !integrator_.is_static() && integrator_.carried_count() == 0 &&
           base_system_.model().has_inertia;
}

void TangentLinearStep::advance_rates(const Stage& stage, const System& system, State& state) const {
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        const NodeLinearization& by = linearizations_[i];
        const Vec6& increment = workspace_.increments[i];
        NodeMotion& trial = state.trial[i];
        trial.v += by.rate * increment.head<3>();
        trial.a += by.acceleration * increment.head<3>();
        trial.omega += by.d_omega * increment.tail<3>();
        trial.alpha += by.d_alpha * increment.tail<3>();
    }
    system.supports().set_rates(
        integrator_.stage_time(stage), {stage.step_time, stage.time_step}, state.trial);
}

void TangentLinearStep::solve_together(const CoupledStages& scheme,
                                       const Stage& step,
                                       std::span<VariedSystem* const> varied) {
    release();
    check(solve_coupled_step(base_system_, scheme, newton_, step, workspace_, base_), "its stages");
    StagesOfStep stages{
        base_system_, scheme, step, base_, workspace_.coupled->asks_for_positions, base_contacts_};
    base_contacts_.clear();
    if (contacts_.are_possible()) {
        base_contacts_.resize(stages.count());
        for (std::size_t j = 0; j < stages.count(); ++j)
            stages.with_stage(j, [&] { contacts_.search(base_); });
    }
    hold_stages(stages);
    if (!exact_)
        exact_ = std::make_unique<ExactMatrix>(base_system_, scheme, workspace_.linear_solver->kind());
    if (!exact_->factorize(stages, workspace_)) fail("the tangent of its stages is singular");
    const std::size_t count = stages.count();
    stage_linearizations_.resize(count * count);
    for (std::size_t i = 0; i < count * count; ++i)
        scheme.linearize(base_,
                         step.time_step,
                         static_cast<int>(i / count),
                         static_cast<int>(i % count),
                         stage_linearizations_[i],
                         base_system_.team());
    for (VariedSystem* one : varied) follow_stages(stages, *one);
    base_.contact = {};
    base_.trial_time = step.end_time;
    contacts_.search(base_);
    if (scheme.ends_with_stage() && !has_hidden_constraints_) return;
    const TimeSpan span{step.step_time, step.time_step};
    const auto place = [&](const System& system, State& state) {
        system.supports().place(step.end_time, state);
        system.supports().set_rates(step.end_time, span, state.trial);
    };
    place(base_system_, base_);
    for (VariedSystem* one : varied) place(one->system, one->state);
    find_accelerations(step.end_time, span, varied);
    if (has_hidden_constraints_) meet_positions(step.end_time, varied);
}

// Newton's method with the matrix of the base, whose equations of joints are those of positions.
void TangentLinearStep::follow_stages(const StagesOfStep& base, VariedSystem& varied) {
    State& state = varied.state;
    const System& system = varied.system;
    varied_contacts_.assign(base_contacts_.size(), {});
    const StagesOfStep stages{
        system, base.scheme, base.step, state, base.asks_for_positions, varied_contacts_, [&](std::size_t j) {
            hold(held_stages_[j], varied.memory_before, varied.held, state);
        }};
    state.stage_motions = base_.stage_motions;
    state.stage_joints.assign(stages.count(), state.joints_previous);
    for (std::size_t j = 0; j < stages.count(); ++j) {
        for (std::size_t i = 0; i < state.joints_previous.size(); ++i)
            state.stage_joints[j][i].multipliers = base_.stage_joints[j][i].multipliers;
        base.with_stage(
            j, [&] { stages.with_stage(j, [&] { place_next_to(base_, stages.time_of(j), varied); }); });
    }
    const auto set_rates = [&] {
        for (std::size_t j = 0; j < stages.count(); ++j)
            system.supports().set_rates(stages.time_of(j), stages.span(), state.stage_motions[j]);
    };
    base.scheme.update_stages(state, base.step, system.team());
    set_rates();
    std::vector<Residual> residuals(stages.count());
    std::vector<Eigen::VectorXd> solutions;
    std::vector<std::vector<Vec6>> increments(stages.count());
    constexpr int with_joints = 8;
    constexpr int with_kinks = 3;  // as follow_equilibrium
    int iterations = system.joints().empty() ? 1 : base.asks_for_positions ? 2 : with_joints;
    if (varied.held.has_kinks()) iterations = std::max(iterations, with_kinks);
    for (int iteration = 0; iteration < iterations; ++iteration) {
        for (std::size_t j = 0; j < stages.count(); ++j) {
            stages.with_stage(j, [&] {
                if (iteration > 0) check_gaps(stages.time_of(j), varied);
                system.compute_residual(state, stages.time_of(j), residuals[j], stages.request());
            });
        }
        const std::vector<std::vector<double>> rows = stages.convert_rows(residuals);
        for (std::size_t j = 0; j < stages.count(); ++j) residuals[j].rows = rows[j];
        exact_->solve(stages, residuals, workspace_, solutions);
        for (std::size_t j = 0; j < stages.count(); ++j) {
            if (!solutions[j].allFinite()) fail("a solution is not finite");
            increments[j].resize(state.previous.size());
            for (std::size_t i = 0; i < state.previous.size(); ++i)
                increments[j][i] = system.equations().increment_of(static_cast<int>(i), solutions[j]);
            stages.with_stage(j, [&] {
                system.joints().advance_multipliers(increments[j], solutions[j], exact_->values_of(j), state);
                for (std::size_t i = 0; i < state.trial.size(); ++i)
                    apply_spin(state.previous[i],
                               increments[j][i].head<3>(),
                               increments[j][i].tail<3>(),
                               state.trial[i]);
            });
        }
        advance_stage_rates(increments, state);
        set_rates();
    }
    base.scheme.end_step(state, base.step, system.team());
    state.joints_trial = state.stage_joints.back();
    if (!varied_contacts_.empty()) state.contact = varied_contacts_.back();
}

// As advance_rates, of all stages.
void TangentLinearStep::advance_stage_rates(const std::vector<std::vector<Vec6>>& increments,
                                            State& state) const {
    for (std::size_t j = 0; j < increments.size(); ++j) {
        for (std::size_t k = 0; k < increments.size(); ++k) {
            for (std::size_t i = 0; i < state.previous.size(); ++i) {
                const NodeLinearization& by = stage_linearizations_[j * increments.size() + k][i];
                NodeMotion& motion = state.stage_motions[j][i];
                motion.v += by.rate * increments[k][i].head<3>();
                motion.a += by.acceleration * increments[k][i].head<3>();
                motion.omega += by.d_omega * increments[k][i].tail<3>();
                motion.alpha += by.d_alpha * increments[k][i].tail<3>();
            }
        }
    }
}

// As split_contact of solve_step.
void TangentLinearStep::split_contact(const Stage& stage, std::span<VariedSystem* const> varied) {
    if (integrator_.is_static() || !base_system_.model().has_inertia || !contacts_.are_impulses() ||
        !contacts_.have_forces(base_, stage.end_time))
        return;
    std::vector<std::vector<Vec6>> shocked;
    for (const VariedSystem* one : varied) {
        std::vector<Vec6>& accelerations = shocked.emplace_back(one->state.trial.size());
        for (std::size_t i = 0; i < accelerations.size(); ++i)
            accelerations[i] << one->state.trial[i].a, one->state.trial[i].alpha;
    }
    find_accelerations(stage.end_time, {stage.step_time, stage.time_step}, varied);
    for (std::size_t i = 0; i < varied.size(); ++i)
        integrator_.split_impulses(varied[i]->state, stage, shocked[i]);
}

bool TangentLinearStep::has_reproduced(const State& after) const {
    constexpr double same = 1e-6;  // of the largest velocity
    const bool has_rates = !integrator_.is_static() && base_system_.model().has_inertia;
    if (!contacts_.are_possible() || !has_rates) return true;
    const double length = base_system_.length_scale();
    double speed = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < after.previous.size(); ++i) {
        const NodeMotion &here = centre_.state.previous[i], &there = after.previous[i];
        speed = std::max({speed, there.v.norm(), length * there.omega.norm()});
        difference =
            std::max({difference, (here.v - there.v).norm(), length * (here.omega - there.omega).norm()});
    }
    return difference <= same * speed;
}

bool TangentLinearStep::is_linear(const ConstraintRequest& request) const {
    return request.level == ConstraintLevel::position &&
           (contacts_.are_possible() || !centre_.held.has_kinks());
}

// Of the residual in the workspace.
void TangentLinearStep::iterate(const System& system, State& state, bool refines) {
    const Eigen::VectorXd residual = gather_residual(system, workspace_.residual, workspace_.values);
    EquilibriumReport report;
    if (!solve_increment(system, residual, workspace_, report)) fail("a solution is not finite");
    if (refines && !system.joints().empty()) {
        const Eigen::VectorXd found = workspace_.vector;
        if (!solve_increment(
                system, -take_regularization(base_system_, workspace_.values, found), workspace_, report))
            fail("a solution is not finite");
        workspace_.vector += found;
    }
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
    const ConstraintRequest request = request_accelerations(step);
    const bool is_projected =
        integrator_.is_explicit() || integrator_.coupled() != nullptr || !stops_.empty();
    for (VariedSystem* one : varied) {
        follow_accelerations(time, step, *one);
        if (!has_hidden_constraints_ || !is_projected) continue;
        one->system.compute_tangent(
            one->state, time, mass_linearizations(one->state.trial.size()), one->values, request);
    }
}

ConstraintRequest TangentLinearStep::request_accelerations(const TimeSpan& step) const {
    ConstraintRequest request{ConstraintLevel::acceleration, step};
    request.stops = stop_choice_;
    if (contacts_.are_impulses()) request.contact_weight = 0.0;
    return request;
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
        system.compute_residual(state, time, workspace_.residual, request_accelerations(step));
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
    const Eigen::VectorXd total = project_velocities(base_system_, time, step, workspace_, base_, report);
    check(report, "velocities that fit the joints");
    ConstraintRequest request{ConstraintLevel::velocity, step, time_scale};
    request.stops = stop_choice_;
    for (VariedSystem* one : varied) {
        follow_projection(
            total,
            *one,
            [&](std::vector<double>& rows) {
                one->system.joints().compute_rows(one->state, time, request, rows);
            },
            [&](std::size_t node, const Vec6& increment) {
                one->state.trial[node].v += increment.head<3>() / time_scale;
                one->state.trial[node].omega += increment.tail<3>() / time_scale;
            });
    }
}

void TangentLinearStep::meet_positions(double time, std::span<VariedSystem* const> varied) {
    EquilibriumReport report;
    const Eigen::VectorXd total = project_positions(base_system_, time, workspace_, base_, report);
    check(report, "positions that fit the joints");
    for (VariedSystem* one : varied) {
        follow_projection(
            total,
            *one,
            [&](std::vector<double>& rows) {
                one->system.joints().compute_rows(one->state, time, {.stops = stop_choice_}, rows);
            },
            [&](std::size_t node, const Vec6& increment) {
                apply_spin(one->state.previous[node],
                           increment.head<3>(),
                           increment.tail<3>(),
                           one->state.trial[node]);
            });
    }
}

}  // namespace gxrod
