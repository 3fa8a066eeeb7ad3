#include "analyses/ledger.hpp"

namespace gxrod {

Ledger::Ledger(const System& system, const Integrator& integrator, const State& state)
    : system_(&system), power_weights_(integrator.power_weights()) {
    const Balance balance = system.compute_balance(state);
    initial_energy_ = balance.kinetic_energy + balance.strain_energy;
    initial_potential_ = balance.gravity_potential;
}

void Ledger::add_work(const State& state,
                      double time,
                      const std::vector<double>& load_power,
                      double time_step) {
    if (power_weights_.empty()) {
        load_work_ += system_->compute_load_work(state, time);
        return;
    }
    for (std::size_t i = 0; i < power_weights_.size(); ++i) {
        load_work_ += time_step * power_weights_[i] * load_power[i];
    }
}

LedgerRow Ledger::row(const State& state) const {
    const Balance balance = system_->compute_balance(state);
    LedgerRow row;
    row.kinetic_energy = balance.kinetic_energy;
    row.strain_energy = balance.strain_energy;
    row.external_work = load_work_ - (balance.gravity_potential - initial_potential_);
    row.energy_error = row.kinetic_energy + row.strain_energy - initial_energy_ - row.external_work;
    row.linear_momentum = balance.momentum.linear;
    row.angular_momentum = balance.momentum.angular;
    return row;
}

}  // namespace gxrod
