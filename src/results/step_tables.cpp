#include "results/step_tables.hpp"

namespace gxrod {
namespace {

AppendDataset<double> energy(const Hdf5Handle& ledger, const char* name, const char* description) {
    return {ledger, {name, description, "none", "force·length"}, scalar_row};
}

std::span<const double> numbers(const Vec3& vector) { return {vector.data(), 3}; }

}  // namespace

LedgerTable::LedgerTable(const Hdf5Handle& ledger)
    : kinetic_energy_(energy(ledger, "kinetic_energy", "kinetic energy")),
      strain_energy_(energy(ledger, "strain_energy", "strain energy")),
      external_work_(
          energy(ledger, "external_work", "work of loads, gravity and moved supports since t = 0")),
      dissipated_energy_(energy(ledger, "dissipated_energy", "energy lost to damping since t = 0")),
      energy_error_(
          energy(ledger,
                 "energy_error",
                 "(kinetic + strain energy) - its value at t = 0 - external work + dissipated energy")),
      linear_momentum_(
          ledger, {"linear_momentum", "linear momentum", "spatial", "mass·length/time"}, vector_row),
      angular_momentum_(
          ledger,
          {"angular_momentum", "angular momentum about the origin", "spatial", "mass·length²/time"},
          vector_row) {}

void LedgerTable::append(const LedgerRow& row) {
    kinetic_energy_.append(row.kinetic_energy);
    strain_energy_.append(row.strain_energy);
    external_work_.append(row.external_work);
    dissipated_energy_.append(row.dissipated_energy);
    energy_error_.append(row.energy_error);
    linear_momentum_.append(numbers(row.linear_momentum));
    angular_momentum_.append(numbers(row.angular_momentum));
}

void LedgerTable::flush() {
    for (AppendDataset<double>* column : {&kinetic_energy_,
                                          &strain_energy_,
                                          &external_work_,
                                          &dissipated_energy_,
                                          &energy_error_,
                                          &linear_momentum_,
                                          &angular_momentum_}) {
        column->flush();
    }
}

SolverTable::SolverTable(const Hdf5Handle& solver)
    : time_step_(solver, {"time_step", "length of the step that ended here", "none", "time"}, scalar_row),
      residual_(
          solver, {"residual", "scaled residual of the step's last equilibrium", "none", "1"}, scalar_row),
      newton_iterations_(solver,
                         {"newton_iterations", "Newton iterations over all stages of the step", "none", "1"},
                         scalar_row),
      rejected_steps_(solver,
                      {"rejected_steps", "trial steps cut before this one was accepted", "none", "1"},
                      scalar_row) {}

void SolverTable::append(const SolverRow& row) {
    time_step_.append(row.time_step);
    residual_.append(row.residual);
    newton_iterations_.append(row.newton_iterations);
    rejected_steps_.append(row.rejected_steps);
}

void SolverTable::flush() {
    time_step_.flush();
    residual_.flush();
    newton_iterations_.flush();
    rejected_steps_.flush();
}

}  // namespace gxrod
