#include "results/step_tables.hpp"

namespace gxrod {
namespace {

AppendDataset<double> energy(const Hdf5Handle& ledger,
                             hsize_t rows,
                             const char* name,
                             const char* description) {
    return {ledger, {name, description, "none", "force·length"}, scalar_row, rows};
}

std::span<const double> numbers(const Vec3& vector) { return {vector.data(), 3}; }

}  // namespace

LedgerTable::LedgerTable(const Hdf5Handle& ledger, hsize_t rows)
    : kinetic_energy_(energy(ledger, rows, "kinetic_energy", "kinetic energy")),
      strain_energy_(energy(ledger, rows, "strain_energy", "strain energy")),
      external_work_(
          energy(ledger, rows, "external_work", "work of loads, gravity and moved supports since t = 0")),
      work_uncertainty_(
          energy(ledger,
                 rows,
                 "work_uncertainty",
                 "how far the work of the load step that ended here may be off; 0 in dynamics")),
      dissipated_energy_(energy(ledger, rows, "dissipated_energy", "energy lost to damping since t = 0")),
      numerical_dissipation_(energy(ledger,
                                    rows,
                                    "numerical_dissipation",
                                    "energy that the time integration itself takes away since t = 0")),
      energy_error_(
          energy(ledger,
                 rows,
                 "energy_error",
                 "(kinetic + strain energy) - its value at t = 0 - external work + dissipated energy + "
                 "numerical dissipation")),
      linear_momentum_(
          ledger, {"linear_momentum", "linear momentum", "spatial", "mass·length/time"}, vector_row, rows),
      angular_momentum_(
          ledger,
          {"angular_momentum", "angular momentum about the origin", "spatial", "mass·length²/time"},
          vector_row,
          rows) {}

void LedgerTable::append(const LedgerRow& row) {
    kinetic_energy_.append(row.kinetic_energy);
    strain_energy_.append(row.strain_energy);
    external_work_.append(row.external_work);
    work_uncertainty_.append(row.work_uncertainty);
    dissipated_energy_.append(row.dissipated_energy);
    numerical_dissipation_.append(row.numerical_dissipation);
    energy_error_.append(row.energy_error);
    linear_momentum_.append(numbers(row.linear_momentum));
    angular_momentum_.append(numbers(row.angular_momentum));
}

std::array<AppendDataset<double>*, 9> LedgerTable::columns() {
    return {&kinetic_energy_,
            &strain_energy_,
            &external_work_,
            &work_uncertainty_,
            &dissipated_energy_,
            &numerical_dissipation_,
            &energy_error_,
            &linear_momentum_,
            &angular_momentum_};
}

void LedgerTable::flush() {
    for (AppendDataset<double>* column : columns()) column->flush();
}

void LedgerTable::trim() {
    for (AppendDataset<double>* column : columns()) column->trim();
}

SolverTable::SolverTable(const Hdf5Handle& solver, bool is_static, hsize_t rows)
    : time_step_(
          solver, {"time_step", "length of the step that ended here", "none", "time"}, scalar_row, rows),
      residual_(solver,
                {"residual", "scaled residual of the step's last equilibrium", "none", "1"},
                scalar_row,
                rows),
      newton_iterations_(solver,
                         {"newton_iterations", "Newton iterations over all stages of the step", "none", "1"},
                         scalar_row,
                         rows),
      rejected_steps_(solver,
                      {"rejected_steps", "trial steps cut before this one was accepted", "none", "1"},
                      scalar_row,
                      rows) {
    if (!is_static) return;
    negative_pivots_.emplace(
        solver,
        DatasetLabel{"negative_pivots",
                     "negative pivots of the tangent: 0 where the equilibrium is stable; with "
                     "loads that follow, 1 where the tangent's determinant is negative; -1 if "
                     "not counted",
                     "none",
                     "1"},
        scalar_row,
        rows);
}

void SolverTable::append(const SolverRow& row) {
    time_step_.append(row.time_step);
    residual_.append(row.residual);
    newton_iterations_.append(row.newton_iterations);
    rejected_steps_.append(row.rejected_steps);
    if (negative_pivots_) negative_pivots_->append(row.negative_pivots);
}

template <class Action>
void SolverTable::for_each_column(Action&& action) {
    action(time_step_);
    action(residual_);
    action(newton_iterations_);
    action(rejected_steps_);
    if (negative_pivots_) action(*negative_pivots_);
}

void SolverTable::flush() {
    for_each_column([](auto& column) { column.flush(); });
}

void SolverTable::trim() {
    for_each_column([](auto& column) { column.trim(); });
}

}  // namespace gxrod
