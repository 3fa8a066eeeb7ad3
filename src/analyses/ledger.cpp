#include "analyses/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "assembly/contact/contacts.hpp"
#include "assembly/system_measures.hpp"
#include "state/energy_jump.hpp"

namespace gxrod {

namespace {

// What nodes, and then the coordinates of joints, did in a step.
std::vector<Vec6> find_movement(const System& system, const State& state, double time) {
    std::vector<Vec6> movement = compute_movement(state);
    const std::vector<Vec6> of_joints = system.joints().compute_movement(state, time);
    movement.insert(movement.end(), of_joints.begin(), of_joints.end());
    return movement;
}

// The mean of the forces at both ends of a step times what nodes and joints did in it.
double compute_mean_work(const std::vector<Vec6>& before,
                         const std::vector<Vec6>& after,
                         const std::vector<Vec6>& movement) {
    double work = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i) work += 0.5 * (before[i] + after[i]).dot(movement[i]);
    return work;
}

// Where supports move a node, no scheme has found how it moves.
void clear_moved_rates(const System& system, std::vector<NodeMotion>& rates) {
    const Supports& supports = system.supports();
    for (const Support* support : supports.moving()) {
        const HeldComponents& held = supports.held(support->node);
        NodeMotion& motion = rates[support->node];
        const Mat3& Q = supports.axes(support->node);
        Vec3 own = Q.transpose() * motion.v;
        for (int i = 0; i < 3; ++i) {
            if (held[i]) own[i] = 0.0;
        }
        motion.v = Q * own;
        if (held[3] && held[4] && held[5]) motion.omega.setZero();
    }
}

}  // namespace

Ledger::Ledger(const System& system,
               const Integrator& integrator,
               const State& state,
               const Residual& residual,
               bool is_loaded,
               const LedgerTotals* before)
    : Ledger(system, integrator) {
    if (weighs_powers()) {
        power_ = compute_power(system, state, state.time, residual);
    } else if (integrator.is_static() && !is_loaded && before == nullptr) {
        // Stress-free, the model carries no load yet: one that has a value at t = 0 grows to it in the first
        // step, as all others do.
        forces_.assign(state.trial.size() + system.joints().count(), Vec6::Zero());
    } else {
        forces_ = compute_forces(state, state.time, residual);
    }
    if (integrator.is_static()) {
        // A start that is bent, or has taut springs, is not in equilibrium: the first step releases its
        // energy.
        held_ = residual.nodal;
        if (!is_loaded && before == nullptr) {
            const std::vector<Vec6> loads = SystemMeasures(system).compute_load_forces(state, state.time);
            for (std::size_t i = 0; i < held_.size(); ++i) held_[i] += loads[i];
        }
    }
    const Balance balance = SystemMeasures(system).compute_balance(state, state.time);
    initial_energy_ = balance.kinetic_energy + balance.strain_energy;
    initial_potential_ = balance.gravity_potential;
    strain_energy_ = balance.strain_energy;
    fluid_forces_ = SystemMeasures(system).compute_surrounding_forces(state, state.time);
    contact_energy_ = initial_contact_energy_ = Contacts(system).compute_energy(state, state.time);
    if (before == nullptr) return;
    initial_energy_ = before->initial_energy;
    work_ = before->external_work;
    // Where a stage without time follows, the motion stops.
    dissipated_ = before->dissipated + before->kinetic_energy - balance.kinetic_energy;
    dissipated_by_scheme_ = before->dissipated_by_scheme;
    fluid_work_ = before->fluid_work;
    contact_loss_ = before->contact_loss;
    initial_contact_energy_ = before->initial_contact_energy;
    largest_energy_ = before->largest_energy;
    // The errors of the stages before, as of the trapezoidal rule over load steps, are not gains of contact.
    if (limits_energy()) dissipated_by_scheme_ -= row(state).energy_error;
}

LedgerTotals Ledger::totals(const State& state) const {
    const LedgerRow at_end = row(state);
    return {initial_energy_,
            at_end.external_work,
            dissipated_,
            dissipated_by_scheme_,
            fluid_work_,
            contact_loss_,
            initial_contact_energy_,
            at_end.kinetic_energy,
            std::max({largest_energy_, at_end.strain_energy, std::abs(at_end.external_work)})};
}

std::vector<Vec6> Ledger::compute_forces(const State& state, double time, const Residual& residual) const {
    std::vector<Vec6> forces = SystemMeasures(*system_).compute_load_forces(state, time);
    SystemMeasures(*system_).add_support_forces(residual, forces);
    const std::vector<Vec6> of_joints = system_->joints().compute_driving_forces(state, time);
    forces.insert(forces.end(), of_joints.begin(), of_joints.end());
    return forces;
}

// What a stop takes when it begins to hold is the energy that is gone within its step.
void Ledger::add_step(const State& state, const Step& step) {
    const Model& model = system_->model();
    const bool is_blow =
        model.has_inertia && model.has_time && !limits_energy() && system_->joints().has_just_stopped(state);
    if (!is_blow) return add_any_step(state, step);
    State before = state;
    before.trial = before.previous;
    before.joints_trial = before.joints_previous;
    const double error = row(before).energy_error;
    const double by_scheme = dissipated_by_scheme_;
    add_any_step(state, step);
    dissipated_by_scheme_ = by_scheme;
    State after = state;
    after.time = step.time;
    dissipated_ += std::max(error - row(after).energy_error, 0.0);
}

void Ledger::add_any_step(const State& state, const Step& step) {
    law_dissipation_ = SystemMeasures(*system_).compute_law_dissipation(state, step.time);
    drive_work_ = SystemMeasures(*system_).compute_drive_work(state, step.time);
    if (weighs_powers()) {
        add_powers(step);
        work_ += drive_work_;
    } else {
        std::vector<Vec6> forces = compute_forces(state, step.time, step.residual);
        if (integrator_->is_static()) {
            add_load_step(state, step, forces);
        } else {
            work_ += compute_mean_work(forces_, forces, find_movement(*system_, state, step.time));
            work_ += drive_work_;
            if (system_->traits().is_damped)
                dissipated_ += SystemMeasures(*system_).compute_damping_action(state) / step.time_step;
        }
        forces_ = std::move(forces);
    }
    dissipated_ += law_dissipation_ + system_->joints().compute_slip_dissipation(state);
    add_fluid_work(state, step.time);
    add_contact_work(state, step.time);
    if (integrator_->conserves()) balance_ = SystemMeasures(*system_).compute_balance(state, step.time);
    if (limits_energy()) {
        const bool has_touched =
            touches() || contact_loss_ != 0.0 ||
            std::ranges::any_of(step.stage_powers, [](const Power& one) { return one.contact.touches; });
        book_loss(state, step.time, has_touched);
    } else {
        dissipated_by_scheme_ += compute_scheme_dissipation(state, step.time_step);
    }
}

bool Ledger::limits_energy() const {
    const Model& model = system_->model();
    return Contacts(*system_).are_possible() && model.has_inertia && model.has_time;
}

void Ledger::book_loss(const State& state, double time, bool touches) {
    balance_ = SystemMeasures(*system_).compute_balance(state, time);
    const LedgerRow at_end = row(state);
    const double size =
        std::max(at_end.kinetic_energy + std::abs(at_end.strain_energy) + at_end.contact_energy,
                 std::abs(at_end.external_work));
    // Until something touches for the first time nothing is limited: no impact has excited vibrations, and
    // the work of supports that set a motion off is uncertain by much of all energy that there is at its
    // start.
    const bool has_touched = touches || largest_energy_ > 0.0;
    largest_energy_ = (has_touched ? 1.0 : -1.0) * std::max(std::abs(largest_energy_), size);
    if (!has_touched) {
        dissipated_by_scheme_ -= at_end.energy_error;
        energy_error_ = 0.0;
        return;
    }
    energy_error_ = at_end.energy_error;
    if (energy_error_ < 0.0) dissipated_by_scheme_ -= std::exchange(energy_error_, 0.0);
}

double Ledger::surplus() const {
    constexpr double tolerated = 1e-4;
    const bool has_touched = largest_energy_ > 0.0;
    if (!limits_energy() || !has_touched || energy_error_ <= tolerated * largest_energy_) return 0.0;
    return energy_error_ - 0.5 * tolerated * largest_energy_;
}

// Of the mean of the forces at both ends of the step, in every scheme.
void Ledger::add_fluid_work(const State& state, double time) {
    if (fluid_forces_.empty()) return;
    std::vector<Vec6> forces = SystemMeasures(*system_).compute_surrounding_forces(state, time);
    fluid_work_ += compute_mean_work(fluid_forces_, forces, compute_movement(state));
    fluid_forces_ = std::move(forces);
}

void Ledger::add_contact_work(const State& state, double time) {
    const Contacts contacts(*system_);
    if (!contacts.are_possible()) return;
    const ContactWork work = contacts.compute_work(state, time, contact_energy_);
    work_ += work.by_obstacles;
    // What contact would give is left to the surplus.
    contact_loss_ += limits_energy() ? std::max(work.loss, 0.0) : work.loss;
    if (integrator_->is_static()) step_work_.uncertainty += work.uncertainty;
    const double energy = contacts.compute_energy(state, time);
    contact_change_ = energy - contact_energy_ + work.loss - work.by_obstacles;
    contact_energy_ = energy;
}

void Ledger::add_load_step(const State& state, const Step& step, const std::vector<Vec6>& forces) {
    LoadStep load_step{forces, find_movement(*system_, state, step.time), step.time_step};
    for (std::size_t i = 0; i < forces.size(); ++i) load_step.force_change[i] -= forces_[i];
    step_work_ = compute_step_work(forces_, load_step, load_step_);
    step_work_.work += drive_work_;
    release_ = 0.0;
    for (std::size_t i = 0; i < held_.size(); ++i) release_ += std::abs(held_[i].dot(load_step.movement[i]));
    held_.clear();
    step_work_.uncertainty += release_;
    // Where rods come to touch something within the step, no rule is better than the trapezoidal one.
    if (Contacts(*system_).are_possible())
        step_work_.uncertainty += compute_step_work(forces_, load_step, {}).uncertainty;
    work_before_ = work_;
    work_ += step_work_.work;
    load_step_ = std::move(load_step);
    forces_before_ = std::move(forces_);
    strain_energy_before_ = strain_energy_;
    balance_ = SystemMeasures(*system_).compute_balance(state, step.time);
    strain_energy_ = balance_->strain_energy;
    largest_energy_before_ = largest_energy_;
    measure_largest_energy();
}

void Ledger::measure_largest_energy() {
    largest_energy_ = std::max({largest_energy_before_, strain_energy_, std::abs(work_)});
}

bool Ledger::is_unclear() const {
    if (!integrator_->is_static()) return false;
    const double imbalance =
        strain_energy_ + law_dissipation_ + contact_change_ - strain_energy_before_ - step_work_.work;
    return std::abs(imbalance) > energy_worth_a_word * largest_energy_ + release_;
}

void Ledger::replace_work(const StepWork& work) {
    step_work_ = work;
    step_work_.uncertainty += release_;
    work_ = work_before_ + work.work;
    measure_largest_energy();
}

void Ledger::begin_settling(const State& state, double time, const Residual& residual) {
    forces_before_settling_ = compute_forces(state, time, residual);
    error_before_settling_ = row(state).energy_error;
}

void Ledger::end_settling(const State& state, double time, const Residual& residual) {
    std::vector<Vec6> forces = compute_forces(state, time, residual);
    work_ += compute_mean_work(forces_before_settling_, forces, find_movement(*system_, state, time)) +
             SystemMeasures(*system_).compute_drive_work(state, time);
    dissipated_ += SystemMeasures(*system_).compute_law_dissipation(state, time) +
                   system_->joints().compute_slip_dissipation(state);
    add_fluid_work(state, time);
    add_contact_work(state, time);
    if (!weighs_powers()) forces_ = std::move(forces);
    load_step_ = {};
    const Balance balance = SystemMeasures(*system_).compute_balance(state, time);
    strain_energy_ = balance.strain_energy;
    if (integrator_->is_static() || balance_) balance_ = balance;
    dissipated_ += std::max(error_before_settling_ - row(state).energy_error, 0.0);
    largest_energy_before_ = largest_energy_;
    measure_largest_energy();
}

void Ledger::settle_load_step() {
    const double stored = strain_energy_ - strain_energy_before_;
    const double work = std::max(step_work_.work, stored + law_dissipation_);
    dissipated_ += work - stored - law_dissipation_;
    replace_work({work, step_work_.uncertainty});
    load_step_.length = 0.0;
}

void Ledger::add_powers(const Step& step) {
    double work = power_weights_[0] * power_.driving;
    double dissipated = power_weights_[0] * power_.damping;
    for (std::size_t i = 0; i < step.stage_powers.size(); ++i) {
        work += power_weights_[i + 1] * step.stage_powers[i].driving;
        dissipated += power_weights_[i + 1] * step.stage_powers[i].damping;
    }
    work_ += step.time_step * work;
    // The power is not negative, but weights are: where steps do not resolve it, their sum may be.
    dissipated_ += step.time_step * std::max(dissipated, 0.0);
    add_contact_powers(step);
    power_ = step.stage_powers.back();
}

void Ledger::add_contact_powers(const Step& step) {
    ContactPower mean;
    for (std::size_t i = 0; i < step.stage_powers.size(); ++i) {
        mean.by_obstacles += power_weights_[i + 1] * step.stage_powers[i].contact.by_obstacles;
        mean.damping += power_weights_[i + 1] * step.stage_powers[i].contact.damping;
    }
    work_ += step.time_step * mean.by_obstacles;
    contact_loss_ += step.time_step * std::max(mean.damping, 0.0);
}

double Ledger::compute_scheme_dissipation(const State& state, double time_step) const {
    const int terms = integrator_->dissipation_terms();
    if (terms == 0) return 0.0;
    double energy = 0.0;
    std::vector<NodeMotion> rates = state.trial;
    for (int term = 0; term < terms; ++term) {
        integrator_->set_dissipated_rates(state, time_step, term, rates);
        clear_moved_rates(*system_, rates);
        energy += 2.0 * SystemMeasures(*system_).compute_kinetic_energy(rates);
    }
    return energy;
}

LedgerMemory Ledger::memory() const {
    LedgerMemory memory;
    memory.initial_energy = initial_energy_;
    memory.initial_potential = initial_potential_;
    memory.work = work_;
    memory.dissipated = dissipated_;
    memory.dissipated_by_scheme = dissipated_by_scheme_;
    memory.fluid_work = fluid_work_;
    memory.contact_loss = contact_loss_;
    memory.contact_energy = contact_energy_;
    memory.initial_contact_energy = initial_contact_energy_;
    memory.fluid_forces = fluid_forces_;
    memory.driving_power = power_.driving;
    memory.damping_power = power_.damping;
    memory.load_step = load_step_.length;
    memory.forces = forces_;
    memory.force_change = load_step_.force_change;
    memory.movement = load_step_.movement;
    if (integrator_->is_static() && load_step_.length == 0.0) {
        // Room for those of later steps, in results that were started before the first one.
        memory.force_change.assign(forces_.size(), Vec6::Zero());
        memory.movement.assign(forces_.size(), Vec6::Zero());
    }
    memory.strain_energy = strain_energy_;
    memory.largest_energy = largest_energy_;
    return memory;
}

void Ledger::resume(const LedgerMemory& memory) {
    initial_energy_ = memory.initial_energy;
    initial_potential_ = memory.initial_potential;
    work_ = memory.work;
    dissipated_ = memory.dissipated;
    dissipated_by_scheme_ = memory.dissipated_by_scheme;
    fluid_work_ = memory.fluid_work;
    contact_loss_ = memory.contact_loss;
    contact_energy_ = memory.contact_energy;
    initial_contact_energy_ = memory.initial_contact_energy;
    fluid_forces_ = memory.fluid_forces;
    power_ = {memory.driving_power, memory.damping_power};
    forces_ = memory.forces;
    load_step_ = {memory.force_change, memory.movement, memory.load_step};
    strain_energy_ = memory.strain_energy;
    largest_energy_ = memory.largest_energy;
}

LedgerRow Ledger::row(const State& state) const {
    const Balance balance =
        balance_ ? *balance_ : SystemMeasures(*system_).compute_balance(state, state.time);
    LedgerRow row;
    row.kinetic_energy = balance.kinetic_energy;
    // A resumed series of equilibria continues from the last one, to the last bit.
    row.strain_energy = integrator_->is_static() ? strain_energy_ : balance.strain_energy;
    row.external_work = work_ - (balance.gravity_potential - initial_potential_);
    row.fluid_work = fluid_work_;
    row.work_uncertainty = step_work_.uncertainty;
    row.dissipated_energy = dissipated_;
    row.numerical_dissipation = dissipated_by_scheme_;
    row.contact_energy = contact_energy_;
    row.contact_loss = contact_loss_;
    row.energy_error = row.kinetic_energy + row.strain_energy - initial_energy_ + row.contact_energy -
                       initial_contact_energy_ - row.external_work + dissipated_ + dissipated_by_scheme_ +
                       contact_loss_;
    if (has_drive_) row.external_work += std::exchange(row.energy_error, 0.0);
    row.linear_momentum = balance.momentum.linear;
    row.angular_momentum = balance.momentum.angular;
    return row;
}

}  // namespace gxrod
