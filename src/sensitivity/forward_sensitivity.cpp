#include "sensitivity/forward_sensitivity.hpp"

#include <stdexcept>

#include "integrators/load_stepping.hpp"
#include "rotation/rotation_map.hpp"
#include "solvers/newton_steps.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

bool have_equal_forms(const Model& a, const Model& b) {
    const auto equal_rods = [](const Rod& one, const Rod& other) {
        return one.element_nodes == other.element_nodes && one.order == other.order && one.kind == other.kind;
    };
    return a.nodes.size() == b.nodes.size() && a.bodies.size() == b.bodies.size() &&
           std::ranges::equal(a.rods, b.rods, equal_rods) && a.joints.size() == b.joints.size() &&
           a.gears.size() == b.gears.size() && a.sleeves.size() == b.sleeves.size();
}

[[noreturn]] void fail(const char* what) {
    throw std::runtime_error(std::string("the derivative of a step cannot be found: ") + what);
}

void check(const EquilibriumReport& report, const char* what) {
    if (!report.converged()) fail(what);
}

// What an input was set to; one that was not set has its own course in each model.
void take_inputs(const Model& from, const System& to) {
    for (std::size_t i = 0; i < from.inputs.size(); ++i) {
        InputState state = from.inputs[i]->state();
        Input& input = *to.model().inputs[i];
        state.planned = input.state().planned;
        input.recall(state);
    }
    to.forget_loads();
}

}  // namespace

ForwardSensitivity::ForwardSensitivity(const Model& base, const VariedModels& models)
    : sides_{Side{models.near.up, System(models.near.up), models.near.step},
             Side{models.near.down, System(models.near.down), -models.near.step},
             Side{models.far.up, System(models.far.up), models.far.step},
             Side{models.far.down, System(models.far.down), -models.far.step}} {
    const System system(base);
    for (const Side& side : sides_) {
        if (!have_equal_forms(base, side.model))
            throw std::invalid_argument("it changes which nodes and elements there are");
        if (system.equations().count() != side.system.equations().count())
            throw std::invalid_argument("it changes which motions are held");
    }
}

template <class Find>
StateDirection ForwardSensitivity::differentiate_by(Find&& find) const {
    const StateDirection near = differentiate(find(sides_[0]), find(sides_[1]), sides_[0].amount);
    const StateDirection far = differentiate(find(sides_[2]), find(sides_[3]), sides_[2].amount);
    return extrapolate(near, far);
}

State ForwardSensitivity::start_one(const System& system,
                                    const Integrator& integrator,
                                    const TimeSpan& first_step,
                                    LinearSolverKind solver) const {
    State state = system.initial_state();
    system.supports().place(0.0, state);
    SolverWorkspace workspace(system, solver);
    if (!integrator.is_static() && system.model().has_inertia)
        check(solve_accelerations(system, 0.0, first_step, workspace, state), "accelerations at t = 0");
    if (integrator.has_algorithmic_accelerations()) state.algorithmic_trial.resize(state.trial.size());
    integrator.start(state);
    system.joints().start(state);
    system.commit(state, 0.0);
    return state;
}

void ForwardSensitivity::start(const Integrator& integrator,
                               const TimeSpan& first_step,
                               LinearSolverKind solver) {
    direction_ = differentiate_by(
        [&](const Side& side) { return start_one(side.system, integrator, first_step, solver); });
}

// (G2): the trial motions of the step where they are, but for what supports prescribe; then one iteration.
State ForwardSensitivity::advance_one(const System& system,
                                      double amount,
                                      const Integrator& integrator,
                                      const Stage& stage,
                                      const State& before,
                                      const State& after,
                                      SolverWorkspace& workspace) const {
    State state = before;
    move_along(direction_, amount, state);
    undo_trial(state);
    integrator.begin_stage(state, stage);
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        NodeMotion& trial = state.trial[i];
        trial.r = after.previous[i].r;
        trial.Lambda = after.previous[i].Lambda;
        trial.theta = log(trial.Lambda * state.previous[i].Lambda.conjugate());
    }
    for (std::size_t i = 0; i < state.joints_trial.size(); ++i)
        state.joints_trial[i].multipliers = after.joints_previous[i].multipliers;
    const double time = integrator.stage_time(stage);
    system.supports().place(time, state);
    integrator.update_rates(state, stage);

    EquilibriumReport report;
    const TimeSpan step{stage.step_time, stage.time_step};
    const ConstraintRequest request{ConstraintLevel::position, step};
    system.compute_residual(state, time, workspace.residual, request);
    const Eigen::VectorXd residual = gather_residual(system, workspace.residual, workspace.values);
    if (!solve_increment(system, residual, workspace, report)) fail("a solution is not finite");
    workspace.increments.resize(state.trial.size());
    for (std::size_t i = 0; i < state.trial.size(); ++i)
        workspace.increments[i] = system.equations().increment_of(static_cast<int>(i), workspace.vector);
    system.joints().advance_multipliers(workspace.increments, workspace.vector, workspace.values, state);
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        const Vec6& increment = workspace.increments[i];
        apply_spin(state.previous[i], increment.head<3>(), increment.tail<3>(), state.trial[i]);
    }
    integrator.update_rates(state, stage);
    integrator.end_stage(state, stage);
    system.commit(state, time);
    return state;
}

void ForwardSensitivity::take_inputs(const Model& base) {
    for (const Side& side : sides_) gxrod::take_inputs(base, side.system);
}

void ForwardSensitivity::advance(const Integrator& integrator,
                                 const Stage& stage,
                                 const State& before,
                                 const State& after,
                                 SolverWorkspace& workspace) {
    direction_ = differentiate_by([&](const Side& side) {
        return advance_one(side.system, side.amount, integrator, stage, before, after, workspace);
    });
}

std::vector<double> ForwardSensitivity::differentiate_function(
    const State& state,
    const std::function<std::vector<double>(const System&, const State&, std::size_t side)>& function) const {
    std::array<std::vector<double>, 4> values;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        State moved = state;
        move_along(direction_, sides_[i].amount, moved);
        undo_trial(moved);
        values[i] = function(sides_[i].system, moved, i);
    }
    std::vector<double> derivative(values[0].size());
    for (std::size_t k = 0; k < derivative.size(); ++k) {
        const double near = (values[0][k] - values[1][k]) / (2.0 * sides_[0].amount);
        const double far = (values[2][k] - values[3][k]) / (2.0 * sides_[2].amount);
        derivative[k] = (4.0 * near - far) / 3.0;
    }
    return derivative;
}

Sensitivities::Sensitivities(const SteppedAnalysis& analysis,
                             const AnalysisSettings& settings,
                             const std::vector<VariedModels>& models) {
    const auto* dynamic = std::get_if<DynamicSettings>(&settings);
    const bool is_static = std::holds_alternative<StaticSettings>(settings);
    if (dynamic != nullptr && dynamic->has_inertia) integrator_ = make_integrator(*dynamic);
    if (is_static) integrator_ = std::make_unique<LoadStepping>();
    if (!integrator_) throw std::invalid_argument("derivatives are there for static and dynamic analyses");
    if (integrator_->is_explicit() || integrator_->stage_count() > 1)
        throw std::invalid_argument(
            "derivatives are there for newmark-simplified, newmark-ibrahimbegovic and generalized-alpha, not "
            "for schemes of several stages");
    const System& system = analysis.system();
    // Their velocities are fitted to the joints by the matrix that Newton's method had last.
    if (!is_static && !system.joints().are_linear())
        throw std::invalid_argument(
            "derivatives of motions are there without joints, or with those between nodes alone that fix or "
            "release positions; those of equilibria with all joints");
    const LinearSolverKind solver = dynamic != nullptr ? dynamic->linear_solver : LinearSolverKind::automatic;
    workspace_ = std::make_unique<SolverWorkspace>(system, solver);
    for (const VariedModels& varied : models)
        all_.push_back(std::make_unique<ForwardSensitivity>(system.model(), varied));
}

Sensitivities::~Sensitivities() = default;

void Sensitivities::start(const SteppedAnalysis& analysis) {
    const TimeSpan first_step{0.0, analysis.steps().time_step()};
    for (auto& one : all_) one->start(*integrator_, first_step, workspace_->linear_solver->kind());
}

void Sensitivities::advance(const SteppedAnalysis& analysis) {
    const System& system = analysis.system();
    const State& after = analysis.state();
    const Stage stage{0, before_.time, analysis.solver_row().time_step, after.time};
    // The step once more where it converged: its tangent there.
    State step = before_;
    step.trial = after.previous;
    step.joints_trial = after.joints_previous;
    step.resultants.clear();  // the consistent tangent
    step.algorithmic_trial = after.algorithmic_previous;
    for (std::size_t i = 0; i < step.trial.size(); ++i)
        step.trial[i].theta = log(step.trial[i].Lambda * step.previous[i].Lambda.conjugate());
    const TimeSpan span{stage.step_time, stage.time_step};
    integrator_->linearize(step, stage, workspace_->linearizations);
    system.compute_tangent(step,
                           integrator_->stage_time(stage),
                           workspace_->linearizations,
                           workspace_->values,
                           {ConstraintLevel::position, span});
    EquilibriumReport report;
    if (!factorize(system, *workspace_, report)) fail("the tangent is singular");
    for (auto& one : all_) {
        one->take_inputs(system.model());
        one->advance(*integrator_, stage, before_, after, *workspace_);
    }
}

}  // namespace gxrod
