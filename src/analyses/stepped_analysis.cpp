#include "analyses/stepped_analysis.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "analyses/shown_surroundings.hpp"
#include "analyses/start_velocities.hpp"
#include "assembly/contact/contacts.hpp"
#include "assembly/lanes/frame_columns.hpp"
#include "assembly/system_measures.hpp"
#include "assembly/system_values.hpp"
#include "check/findings/stiffness_contrast.hpp"
#include "check/summaries/direction_words.hpp"
#include "elements/spring_line.hpp"
#include "elements/tie_values.hpp"
#include "model/evaluation_error.hpp"
#include "solvers/coupled/coupled_step.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/steps/settling.hpp"
#include "solvers/worst_nodes.hpp"
#include "state/energy_jump.hpp"

namespace gxrod {

namespace {

std::vector<WorstNode> find_places(const System& system,
                                   const EquilibriumReport& report,
                                   const Residual& residual) {
    constexpr std::size_t most = 3;
    if (report.outcome == Outcome::out_of_iterations) return find_worst_nodes(system, residual, most);
    if (report.worst_node < 0) return {};
    return {{report.worst_node, report.worst_component, 0.0}};
}

bool may_come_from_weakness(Outcome outcome) {
    return outcome == Outcome::singular || outcome == Outcome::out_of_iterations ||
           outcome == Outcome::rotation_too_large || outcome == Outcome::element_too_turned;
}

// With a contrast the tangent is good to few digits, so that Newton's method gains but one in several
// iterations. Where a rod comes to lie on something, or leaves it, an equilibrium moves on by few elements in
// each. In a step of a motion little changes, but to cut one costs as much as some thirty iterations.
NewtonSettings with_patience(NewtonSettings newton, bool has_contrast, bool has_contact, bool is_static) {
    if (has_contrast || (has_contact && is_static)) {
        newton.max_iterations *= 10;
    } else if (has_contact) {
        newton.max_iterations *= 2;
    }
    return newton;
}

// With a contrast, of one load step: shorter ones do not make round-off smaller. Slack cables, whose first
// steps may have to be tiny, need fewer.
constexpr int most_rejections = 60;

// A spring that is short compared with its free length, which a step that failed may have taken to nothing;
// "" without one.
std::string find_shrunk_spring(const System& system, const State& state) {
    constexpr double short_of_length = 1e-2;
    for (const Spring& spring : system.model().springs) {
        const SpringLine line = compute_spring_line(spring, state.previous);
        if (line.length < short_of_length * spring.length) return spring.name;
    }
    return "";
}

// Of the model's length, or in rad: how near a support's move is to where its node was left.
constexpr double same_place = 1e-6;
// Of the largest velocity: a rate that goes on.
constexpr double same_rate = 1e-6;
// Of the largest force: what an equilibrium leaves.
constexpr double balanced = 1e-5;

}  // namespace

SteppedAnalysis::SteppedAnalysis(const Model& model,
                                 int threads,
                                 std::unique_ptr<Integrator> integrator,
                                 const NewtonSettings& newton,
                                 LinearSolverKind linear_solver,
                                 std::unique_ptr<StepSequence> steps)
    : team_(threads),
      system_(model, team_),
      integrator_(std::move(integrator)),
      has_contrast_(!find_stiffness_contrasts(model, find_parts(model)).empty()),
      newton_(
          with_patience(newton, has_contrast_, Contacts(system_).are_possible(), integrator_->is_static())),
      linear_solver_(linear_solver),
      workspace_(system_, linear_solver),
      steps_(std::move(steps)),
      state_(system_.initial_state()) {
    if (integrator_->resolves_contact()) resolve_contact(system_);
}

void SteppedAnalysis::refuse_overlaps(double time) {
    const Contacts contacts(system_);
    contacts.search(state_);
    const std::string overlap = contacts.describe_overlap(state_, time);
    if (!overlap.empty()) throw std::runtime_error("at the start " + overlap);
}

void SteppedAnalysis::accept_start(double time, bool is_loaded) {
    refuse_overlaps(time);
    integrator_->start(state_);
    point_values_ = SystemValues(system_).compute_point_values(state_, time, watched_);
    body_values_ = SystemValues(system_).compute_body_surroundings(state_, time);
    system_.commit(state_, time);
    reactions_ = SystemMeasures(system_).compute_reactions(workspace_.residual);
    solver_row_.negative_pivots = counted_pivots();
    ledger_ = std::make_unique<Ledger>(system_,
                                       *integrator_,
                                       state_,
                                       workspace_.residual,
                                       is_loaded,
                                       totals_before_ ? &*totals_before_ : nullptr);
    if (frame() != nullptr) ledger_->add_drive();
}

EquilibriumReport SteppedAnalysis::start_at_rest() {
    for (NodeMotion& motion : state_.trial) {
        motion.v.setZero();
        motion.omega.setZero();
        motion.a.setZero();
        motion.alpha.setZero();
    }
    refuse_overlaps(0.0);
    system_.compute_residual(state_, 0.0, workspace_.residual);
    accept_start();
    return {};
}

EquilibriumReport SteppedAnalysis::start_after(const SteppedAnalysis& before) {
    take_over(before.state_, state_);
    system_.joints().begin_stage(state_, steps_->time());
    totals_before_ = before.ledger_->totals(before.state_);
    for (int i = 0; i < static_cast<int>(state_.trial.size()); ++i)
        system_.equations().hold_rates(i, state_.trial[i]);
    state_.previous = state_.trial;
    if (before.accepted_pivots() >= 0) resume_pivots(before.accepted_pivots());
    if (!integrator_->is_static()) {
        check_moved_supports();
        check_motors();
        if (system_.model().has_inertia) {
            start_note_ = describe_imbalance();
            takes_over_rates_ =
                measure_rate_jump(before.system_, before.state_, system_, state_, steps_->time_step()) <=
                same_rate;
        }
    }
    const EquilibriumReport report = start();
    if (report.converged() && settles_after_stage()) {
        settle();  // as far as it can: the first load step takes what is left
        is_settling_ = false;
    }
    return report;
}

EquilibriumReport SteppedAnalysis::settle() {
    settled_.reset();
    const Stage stage = settling_stage();
    EquilibriumReport report;
    undo_trial(state_);
    state_.trial_time = stage.end_time;
    system_.compute_residual(state_, stage.end_time, workspace_.residual);
    measure_residual(system_, workspace_.residual, report);
    if (report.outcome == Outcome::not_finite) return report;
    const auto are_joints_moved = [&] {
        return !system_.joints().empty() &&
               system_.joints().measure_gap(workspace_.residual.rows, state_).size > same_place;
    };
    const bool is_moved = !integrator_->is_static() &&
                          (find_support_jump(stage.end_time).support != nullptr || are_joints_moved());
    state_.trial_time = state_.time;
    if (report.residual <= *newton_.tolerance && !is_moved) return {};
    is_settling_ = true;
    settled_parts_ = 0;
    NewtonSettings newton = newton_;  // what comes at once is as large as a load step
    if (newton.tangent == TangentKind::automatic || newton.tangent == TangentKind::kept)
        newton.tangent = TangentKind::mixed;
    report = gxrod::settle(
        {system_, settling_integrator(), newton},
        stage,
        workspace_,
        state_,
        {.begin = [&] { ledger_->begin_settling(state_, stage.end_time, workspace_.residual); },
         .end =
             [&] {
                 reactions_ = SystemMeasures(system_).compute_reactions(workspace_.residual);
                 point_values_ = SystemValues(system_).compute_point_values(state_, stage.end_time, watched_);
                 body_values_ = SystemValues(system_).compute_body_surroundings(state_, stage.end_time);
                 ledger_->end_settling(state_, stage.end_time, workspace_.residual);
                 ++settled_parts_;
             }});
    if (!report.converged()) return report;
    is_settling_ = false;
    settled_ = state_;
    settled_stage_ = stage;
    lead_ = stage.time_step;
    return report;
}

void SteppedAnalysis::set_jumps(std::vector<double> jumps) {
    jumps_ = std::move(jumps);
    aim();
}

std::optional<double> SteppedAnalysis::land_on(double time) {
    landing_ = steps_->land_on(time);
    aim();
    return landing_;
}

void SteppedAnalysis::aim() {
    if (jumps_.empty()) return;
    const double now = steps_->time();
    const double close = 1e-9 * steps_->time_step();
    const auto next = std::ranges::find_if(jumps_, [&](double jump) { return jump > now + close; });
    std::optional<double> goal;
    if (next != jumps_.end()) goal = *next;
    if (landing_ && *landing_ > now && (!goal || *landing_ < *goal)) goal = landing_;
    if (goal) steps_->land_on(*goal);
}

EquilibriumReport SteppedAnalysis::settle_after(const SteppedAnalysis& before, double time) {
    take_over(before.state_, state_);
    const EquilibriumReport report =
        solve_step({system_, *integrator_, newton_}, {0, time, 0.0, time}, workspace_, state_);
    if (report.converged()) accept_start(time, true);
    return report;
}

// No force moves a support at once.
void SteppedAnalysis::check_moved_supports() const {
    const SupportJump jump = find_support_jump(0.0);
    if (jump.support == nullptr) return;
    throw EvaluationError(fmt::format(
        "the support at {} begins with a jump, by {:.4g} and {:.4g} rad: its move at t = 0 of this stage "
        "is not where the stage before leaves it",
        system_.model().nodes[jump.support->node].name,
        jump.distance,
        jump.angle));
}

SteppedAnalysis::SupportJump SteppedAnalysis::find_support_jump(double time) const {
    if (!system_.supports().move()) return {};
    State moved = state_;
    system_.supports().place(time, moved);
    for (const Support* support : system_.supports().moving()) {
        const NodeMotion& from = state_.trial[support->node];
        const NodeMotion& to = moved.trial[support->node];
        const double distance = (to.r - from.r).norm();
        const double angle = from.Lambda.angularDistance(to.Lambda);
        const double length = system_.scale_groups().length_at(support->node);
        if (distance > same_place * length || angle > same_place) return {support, distance, angle};
    }
    return {};
}

// Nor a motor.
void SteppedAnalysis::check_motors() const {
    std::vector<double> rows;
    system_.joints().compute_rows(state_, 0.0, {}, rows);
    const LargestGap gap = system_.joints().measure_gap(rows, state_);
    if (gap.size <= same_place) return;
    throw EvaluationError(
        fmt::format("{} begins with a jump of {:.4g} of the model's length, or rad: its move at t = 0 "
                    "of this stage is "
                    "not where the stage before leaves it",
                    system_.joints().name(gap.joint),
                    gap.size));
}

// At the trial motions, with the velocities and accelerations that the stage before leaves.
std::string SteppedAnalysis::describe_imbalance() const {
    Residual residual;
    system_.compute_residual(state_, 0.0, residual);
    const std::vector<WorstNode> worst = find_worst_nodes(system_, residual, 1);
    if (worst.empty() || worst[0].residual <= balanced) return "";
    return fmt::format(
        "it does not begin in equilibrium: out of balance at {}, by {:.3g} of the largest force or moment",
        name_place(system_.model(), worst[0].node, worst[0].component),
        worst[0].residual);
}

namespace {

std::vector<double> flatten_places(const std::vector<RodPlace>& places) {
    std::vector<double> numbers;
    for (const RodPlace& place : places) {
        numbers.insert(numbers.end(),
                       {static_cast<double>(place.rod),
                        static_cast<double>(place.element),
                        place.xi,
                        place.is_asked ? 1.0 : 0.0});
    }
    return numbers;
}

}  // namespace

RestartRecord SteppedAnalysis::restart_record() const {
    RestartRecord record;
    record.nodes = state_.previous;
    record.sections = state_.sections;
    record.memory = state_.memory;
    record.pair_tractions = pack(state_.pair_tractions);
    record.joints = state_.joints_previous;
    record.carried = state_.carried_previous;
    record.reactions = reactions_;
    record.points = point_values_;
    record.point_places = flatten_places(watched_);
    record.bodies = body_values_;
    record.ledger = ledger_->memory();
    record.steps = steps_->memory();
    record.steps.lead = lead_;
    record.negative_pivots = accepted_pivots();
    remember(record);
    return record;
}

bool SteppedAnalysis::resume(const RestartRecord& record) {
    const std::size_t nodes = state_.previous.size();
    const LedgerMemory& books = record.ledger;
    const std::size_t with_joints = nodes + state_.joints_previous.size();
    const std::size_t of_load_step = integrator_->is_static() ? with_joints : 0;
    const bool has_forces = books.forces.size() == (integrator_->power_weights().empty() ? with_joints : 0) &&
                            books.force_change.size() == of_load_step &&
                            books.movement.size() == of_load_step &&
                            books.fluid_forces.size() == (system_.traits().has_surroundings ? nodes : 0);
    const bool has_carried =
        record.carried.size() == nodes * static_cast<std::size_t>(integrator_->carried_count());
    if (record.nodes.size() != nodes || record.reactions.size() != nodes ||
        record.sections.size() != state_.sections.size() || record.memory.size() != state_.memory.size() ||
        record.joints.size() != state_.joints_previous.size() || !has_forces || !has_carried) {
        throw std::invalid_argument("the state to resume from belongs to another model");
    }
    if (!steps_->resume(record.steps)) return false;
    lead_ = record.steps.lead;
    state_.previous = state_.trial = record.nodes;
    state_.sections = record.sections;
    state_.memory = record.memory;
    state_.pair_tractions = unpack(record.pair_tractions);
    state_.joints_previous = state_.joints_trial = record.joints;
    state_.carried_previous = state_.carried_trial = record.carried;
    state_.time = state_.trial_time = steps_->time();
    Contacts(system_).search(state_);
    // A run that is resumed can have other histories.
    point_values_ = record.point_places == flatten_places(watched_)
                        ? record.points
                        : SystemValues(system_).compute_point_values(state_, state_.time, watched_);
    body_values_ = record.bodies;
    resume_pivots(record.negative_pivots);
    reactions_ = record.reactions;
    ledger_ = std::make_unique<Ledger>(system_, *integrator_);
    ledger_->resume(record.ledger);
    if (frame() != nullptr) ledger_->add_drive();
    recall(record);
    aim();
    return true;
}

Stage SteppedAnalysis::next_stage() const {
    constexpr double most = 0.1;  // of a step
    const double length = steps_->time_step();
    const double lead = std::min(lead_, most * length);
    return {0, steps_->time() + lead, length - lead, trial_time()};
}

EquilibriumReport SteppedAnalysis::solve_trial() {
    const auto solve = [&] {
        return solve_step({system_, *integrator_, newton_}, next_stage(), workspace_, state_);
    };
    if (follower_ == nullptr) return solve();
    constexpr int most_trials = 30;
    follower_->begin(state_.time, trial_time());
    int iterations = 0;
    for (int trial = 0; trial < most_trials; ++trial) {
        if (trial > 0) undo_trial(state_);
        system_.forget_loads();
        EquilibriumReport report = solve();
        iterations = report.iterations += iterations;
        if (!report.converged() || !is_to_follow()) return report;
    }
    EquilibriumReport report;
    report.outcome = Outcome::out_of_iterations;
    report.iterations = iterations;
    return report;
}

// Shows the trial to the follower; what is derived of the last accepted state stays.
bool SteppedAnalysis::is_to_follow() {
    const double time = trial_time();
    std::vector<Vec6> reactions = SystemMeasures(system_).compute_reactions(workspace_.residual);
    std::vector<PointValues> points = SystemValues(system_).compute_point_values(state_, time, watched_);
    const auto bodies = SystemValues(system_).compute_body_surroundings(state_, time);
    const auto joints = system_.joints().compute_joint_values(state_, time);
    const auto tendons = system_.model().tendons.empty()
                             ? decltype(tendon_values_){}
                             : SystemValues(system_).compute_tendon_values(state_, time);
    const TieValues ties = compute_tie_values(system_.model(), state_.trial);
    Snapshot snapshot{axis_time() + time - state_.time, state_.trial, {}, reactions, points};
    snapshot.ties = &ties;
    snapshot.joints = joints;
    snapshot.bodies = bodies;
    snapshot.tendons = tendons;
    show_surroundings(system_, state_, time, false, snapshot);
    contact_record_ = record_contacts(system_, state_, time, watched_contacts_, false);
    contact_record_.show_in(snapshot);
    return follower_->follow(snapshot, time);
}

bool SteppedAnalysis::take_step(EquilibriumReport& report) {
    std::vector<Vec6> resultants = state_.resultants;  // none but of the mixed tangent
    const auto undo = [&] {
        undo_trial(state_);
        state_.resultants.swap(resultants);
        tried_ledger_.reset();
    };
    try {
        std::optional<StepStart> start;
        if (integrator_->conserves()) start = note_ledger_start();
        report = solve_trial();
        if (report.converged() && start) tried_ledger_ = conserve_energy(tried_step(), *start, report);
        if (report.converged()) system_.joints().check_ranges(state_, trial_time());
    } catch (...) {
        undo();
        throw;
    }
    // Of schemes of one stage only where steps are chosen by it: there it costs as much as a step's update.
    const bool is_estimated = steps_->needs_error() || integrator_->stage_count() > 1;
    if (report.converged() && is_estimated && integrator_->error_order() > 0) check_error(report);
    if (report.converged()) judge_equilibrium(report);
    if (report.converged() && ledger_->limits_energy())
        tried_ledger_ = limit_energy(tried_step(), solver_row_.rejected_steps, report);
    if (!report.converged()) undo();
    return report.converged();
}

TriedStep SteppedAnalysis::tried_step() {
    return {system_, *integrator_, *ledger_, next_stage(), workspace_, state_};
}

StepStart SteppedAnalysis::note_ledger_start() const {
    StepStart start = note_step_start(system_, state_, steps_->time());
    start.energy_error = ledger_->row(state_).energy_error;
    return start;
}

void SteppedAnalysis::check_error(EquilibriumReport& report) {
    const auto length_at = [&](int node) { return system_.scale_groups().length_at(node); };
    const StepError error =
        workspace_.coupled
            ? measure_step_error(
                  workspace_.coupled->placement_errors, workspace_.coupled->rate_errors, length_at)
            : integrator_->estimate_error(state_, next_stage().time_step, length_at);
    largest_error_ = std::max(largest_error_, error.size);
    if (!steps_->needs_error() || steps_->admits(error.size)) return;
    report.outcome = Outcome::error_too_large;
    report.step_error = error.size;
    report.worst_node = error.node;
    report.worst_component = error.component;
}

bool SteppedAnalysis::shorten_step() {
    if (has_contrast_ && integrator_->is_static()) {
        if (steps_->steps_done() != rejecting_step_) rejections_ = 0;
        rejecting_step_ = steps_->steps_done();
        if (++rejections_ == most_rejections) return false;
    }
    return steps_->reject();
}

EquilibriumReport SteppedAnalysis::begin_anew() {
    const bool has_rates = !integrator_->is_static() && system_.model().has_inertia;
    const bool has_broken = system_.joints().has_just_broken(state_);
    if (settles_here() || (has_broken && !has_rates)) return settle();
    if (!has_broken) return {};
    undo_trial(state_);
    const TimeSpan step{steps_->time(), steps_->time_step()};
    const EquilibriumReport found = solve_accelerations(system_, step.start, step, workspace_, state_);
    if (found.converged()) {
        integrator_->start(state_);
        state_.previous = state_.trial;
        state_.joints_previous = state_.joints_trial;
    }
    undo_trial(state_);
    return found.converged() ? EquilibriumReport{} : found;
}

EquilibriumReport SteppedAnalysis::advance() {
    EquilibriumReport report;
    solver_row_ = SolverRow{};
    section_values_ = std::vector<SectionValues>();  // large compared with what a step needs
    settled_.reset();
    report = begin_anew();
    if (!report.converged()) return report;
    const int iterations = report.iterations;
    while (!take_step(report)) {
        ++solver_row_.rejected_steps;
        if (report.outcome != Outcome::lost_stability) cuts_.add(report, steps_->steps_done());
        if (tries_otherwise(report, false)) continue;
        if (!shorten_step() && !tries_otherwise(report, true)) return report;
    }
    const PhaseTimer timer(workspace_.seconds.update);
    // All allocations come before anything that changes the state to resume from. And before the step becomes
    // the last one: what `simo` elements ask of their nodes depends on it.
    reactions_ = SystemMeasures(system_).compute_reactions(workspace_.residual);
    const double time = trial_time();
    point_values_ = SystemValues(system_).compute_point_values(state_, time, watched_);
    body_values_ = SystemValues(system_).compute_body_surroundings(state_, time);
    keep_step(time);
    if (tried_ledger_) {
        *ledger_ = std::move(*tried_ledger_);
        tried_ledger_.reset();
    } else {
        ledger_->add_step(state_, tried_step().books());
    }
    if (has_relaxed()) {
        ledger_->settle_load_step();
    } else {
        look_into_load_step(report.iterations);
    }
    solver_row_.time_step = steps_->time_step();
    solver_row_.newton_iterations = report.iterations + iterations;
    solver_row_.residual = report.residual;
    if (const Contacts contacts(system_); contacts.are_possible()) {
        const ContactCount touching = contacts.count(state_, time);
        solver_row_.contacts = touching.touching;
        solver_row_.least_gap = std::min(report.least_gap, touching.least_gap);
        solver_row_.shortened = report.shortened;
    }
    note_equilibrium();
    solver_row_.negative_pivots = counted_pivots();
    step_start_ = state_.time;
    last_stage_ = next_stage();
    lead_ = 0.0;
    system_.commit(state_, time);
    if (!jumps_.empty()) state_.time = state_.trial_time = steps_->next_time();
    steps_->accept();
    aim();
    return report;
}

void SteppedAnalysis::keep_step(double time) {
    if (!is_wanted_ || !is_wanted_(state_.time, time)) return;
    if (!interior_) interior_ = std::make_unique<StepInterior>(system_, *integrator_);
    interior_->keep(state_, time, settled_.has_value());
}

std::optional<PathPoint> SteppedAnalysis::find_equilibrium(const PathPoint& from, double load_factor) {
    const double length = load_factor - from.load_factor;
    PathPoint point{load_factor, 0.0, {}, from.turned, {}, from.state, from.dissipated};
    const Stage stage{0, from.load_factor, length, load_factor};
    const EquilibriumReport report =
        solve_step({system_, *integrator_, newton_}, stage, workspace_, point.state);
    if (!report.converged()) return std::nullopt;
    point.iterations = report.iterations;
    for (std::size_t i = 0; i < point.turned.size(); ++i) point.turned[i] += point.state.trial[i].theta;
    point.forces = SystemMeasures(system_).compute_load_forces(point.state, load_factor);
    SystemMeasures(system_).add_support_forces(workspace_.residual, point.forces);
    const std::vector<Vec6> driving = system_.joints().compute_driving_forces(point.state, load_factor);
    point.forces.insert(point.forces.end(), driving.begin(), driving.end());
    point.coordinates = system_.joints().compute_coordinates(point.state.trial, load_factor, point.state);
    point.dissipated += SystemMeasures(system_).compute_law_dissipation(point.state, load_factor);
    point.strain_energy =
        SystemMeasures(system_).compute_balance(point.state, load_factor).strain_energy + point.dissipated;
    system_.commit(point.state, load_factor);
    return point;
}

// Where work and strain energy part, equilibria between both ends of a load step say why. They are discarded
// afterwards; if none can be found, or there is no memory for them, the books stay as they are.
void SteppedAnalysis::look_into_load_step(int iterations) {
    // Contact stores and loses energy as well, which points of a path do not have.
    if (!looks_into_load_steps() || Contacts(system_).are_possible()) return;
    // Iterations that round-off asks for say nothing of a jump.
    const bool is_slow = iterations >= many_iterations && !has_contrast_ && !ledger_->has_released();
    if (!ledger_->is_unclear() && !is_slow) return;
    constexpr double tolerable = 0.25 * energy_worth_a_word;
    constexpr int halvings = 8;
    try {
        const Ledger::LoadStepEnds ends = ledger_->load_step_ends();
        PathPoint from{state_.time, ends.energy_before, ends.forces_before, {}, {}, state_};
        from.turned.assign(state_.trial.size(), Vec3::Zero());
        undo_trial(from.state);
        from.coordinates =
            system_.joints().compute_coordinates(from.state.trial, from.load_factor, from.state);
        PathPoint to{steps_->next_time(), ends.energy_after, ends.forces_after, from.turned, {}, state_};
        to.iterations = iterations;
        to.coordinates = system_.joints().compute_coordinates(state_.trial, to.load_factor, state_);
        for (std::size_t i = 0; i < to.turned.size(); ++i) to.turned[i] = state_.trial[i].theta;
        const auto find = [&](const PathPoint& point, double load_factor) {
            return find_equilibrium(point, load_factor);
        };
        ledger_->replace_work(integrate_path(from, to, {find, tolerable * ends.largest_energy, halvings}));
    } catch (const std::exception&) {
        // A load that is NaN in between, or too little memory.
    }
}

Failure::Phase SteppedAnalysis::failure_phase() const {
    if (is_settling_) return Failure::Phase::instant;
    if (!ledger_) return Failure::Phase::initial_accelerations;
    if (integrator_->is_static()) return Failure::Phase::load_step;
    return integrator_->is_explicit() ? Failure::Phase::explicit_step : Failure::Phase::implicit_step;
}

std::string SteppedAnalysis::find_weakness() {
    const Failure::Phase phase = failure_phase();
    if (phase == Failure::Phase::implicit_step || phase == Failure::Phase::load_step) {
        const Stage stage{0, steps_->time(), steps_->time_step(), steps_->next_time()};
        integrator_->linearize(state_, stage, workspace_.linearizations, team_);
        system_.compute_tangent(state_, state_.time, workspace_.linearizations, workspace_.values);
        if (workspace_.frame) workspace_.frame->add_stiffness(state_, state_.time, workspace_.values);
    }
    const std::optional<Weakness> weakness =
        describe_weakness(system_, state_, system_.pattern(), workspace_.values);
    return weakness && weakness->stiffness < singular_stiffness ? weakness->words : "";
}

Failure SteppedAnalysis::explain(const EquilibriumReport& report) {
    Failure failure;
    failure.phase = failure_phase();
    failure.outcome = report.outcome;
    failure.time = steps_->time();
    failure.time_step = steps_->time_step();
    failure.iterations = report.iterations;
    failure.residual = report.residual;
    failure.step_error = report.step_error;
    failure.limits_energy = ledger_ && ledger_->limits_energy();
    constexpr double open = 1e-9;
    if (report.joint_gap.joint >= 0 && report.joint_gap.size > open) {
        failure.open_joint = system_.joints().name(report.joint_gap.joint);
        failure.joint_gap = report.joint_gap.size;
    }
    if (report.outcome == Outcome::not_finite) failure.shrunk_spring = find_shrunk_spring(system_, state_);
    for (const WorstNode& place : find_places(system_, report, workspace_.residual)) {
        failure.places.push_back(name_place(system_.model(), place.node, place.component));
        failure.nodes.push_back(place.node);
    }
    try {
        if (may_come_from_weakness(report.outcome)) find_reason(failure);
    } catch (const std::exception&) {
        // Too little memory for more factors: the rest is known.
    }
    return failure;
}

void SteppedAnalysis::find_reason(Failure& failure) {
    const bool is_implicit =
        failure.phase == Failure::Phase::implicit_step || failure.phase == Failure::Phase::load_step;
    if (const auto contrast = find_contrast_at(system_.model(), failure.nodes); contrast && is_implicit) {
        failure.contrast = describe(*contrast, system_.model());
        failure.contrast_advice = advise(*contrast);
    } else {
        failure.weakness = find_weakness();
    }
}

Snapshot SteppedAnalysis::snapshot(bool with_elements) {
    section_values_.clear();
    if (with_elements) section_values_ = SystemValues(system_).compute_section_values(state_);
    joint_values_ = system_.joints().compute_joint_values(state_, state_.time);
    Snapshot snapshot{axis_time(), state_.trial, section_values_, reactions_, point_values_};
    ties_ = compute_tie_values(system_.model(), state_.trial);
    snapshot.ties = &ties_;
    snapshot.joints = joint_values_;
    snapshot.bodies = body_values_;
    if (!system_.model().tendons.empty())
        tendon_values_ = SystemValues(system_).compute_tendon_values(state_, state_.time);
    snapshot.tendons = tendon_values_;
    contact_record_ = record_contacts(system_, state_, state_.time, watched_contacts_, with_elements);
    contact_record_.show_in(snapshot);
    show_surroundings(system_, state_, state_.time, with_elements, snapshot);
    return snapshot;
}

}  // namespace gxrod
