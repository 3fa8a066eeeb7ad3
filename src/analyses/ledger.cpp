#include "analyses/ledger.hpp"

namespace gxrod {

namespace {

// The mean of the forces at both ends of a step times what the nodes did in it.
double compute_mean_work(const std::vector<Vec6>& before,
                         const std::vector<Vec6>& after,
                         const State& state) {
    double work = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const Vec6 mean = 0.5 * (before[i] + after[i]);
        work += mean.head<3>().dot(state.trial[i].r - state.previous[i].r) +
                mean.tail<3>().dot(state.trial[i].theta);
    }
    return work;
}

}  // namespace

Ledger::Ledger(const System& system,
               const Integrator& integrator,
               const State& state,
               const Residual& residual)
    : Ledger(system, integrator) {
    forces_ = system.compute_working_forces(state, state.time, residual);
    if (integrator.is_static()) {
        // Free of strain, the model bears no load yet: one that has a value at t = 0 grows to it in the first
        // step, as all others do.
        for (Vec6& force : forces_.driving) force.setZero();
    }
    power_ = compute_power(forces_, state.trial);
    const Balance balance = system.compute_balance(state, state.time);
    initial_energy_ = balance.kinetic_energy + balance.strain_energy;
    initial_potential_ = balance.gravity_potential;
}

void Ledger::add_step(const State& state, const Step& step) {
    WorkingForces forces = system_->compute_working_forces(state, step.time, step.residual);
    if (power_weights_.empty()) {
        driving_work_ += compute_mean_work(forces_.driving, forces.driving, state);
        dissipated_ += compute_mean_work(forces_.damping, forces.damping, state);
    } else {
        driving_work_ += step.time_step * power_weights_[0] * power_.driving;
        dissipated_ += step.time_step * power_weights_[0] * power_.damping;
        for (std::size_t i = 0; i < step.stage_powers.size(); ++i) {
            driving_work_ += step.time_step * power_weights_[i + 1] * step.stage_powers[i].driving;
            dissipated_ += step.time_step * power_weights_[i + 1] * step.stage_powers[i].damping;
        }
        power_ = step.stage_powers.back();
    }
    forces_ = std::move(forces);
}

LedgerMemory Ledger::memory() const {
    LedgerMemory memory;
    memory.initial_energy = initial_energy_;
    memory.initial_potential = initial_potential_;
    memory.driving_work = driving_work_;
    memory.dissipated = dissipated_;
    memory.driving_power = power_.driving;
    memory.damping_power = power_.damping;
    memory.driving = forces_.driving;
    memory.damping = forces_.damping;
    return memory;
}

void Ledger::resume(const LedgerMemory& memory) {
    initial_energy_ = memory.initial_energy;
    initial_potential_ = memory.initial_potential;
    driving_work_ = memory.driving_work;
    dissipated_ = memory.dissipated;
    power_ = {memory.driving_power, memory.damping_power};
    forces_ = {memory.driving, memory.damping};
}

LedgerRow Ledger::row(const State& state) const {
    const Balance balance = system_->compute_balance(state, state.time);
    LedgerRow row;
    row.kinetic_energy = balance.kinetic_energy;
    row.strain_energy = balance.strain_energy;
    row.external_work = driving_work_ - (balance.gravity_potential - initial_potential_);
    row.dissipated_energy = dissipated_;
    row.energy_error =
        row.kinetic_energy + row.strain_energy - initial_energy_ - row.external_work + dissipated_;
    row.linear_momentum = balance.momentum.linear;
    row.angular_momentum = balance.momentum.angular;
    return row;
}

}  // namespace gxrod
