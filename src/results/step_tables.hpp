#pragma once

#include <array>
#include <optional>

#include "results/append_dataset.hpp"
#include "state/step_record.hpp"

namespace gxrod {

// /ledger: energies and momenta, one row a step, after the `rows` that are there. Throws Hdf5Error.
class LedgerTable {
  public:
    LedgerTable(const Hdf5Handle& ledger, hsize_t rows);
    void append(const LedgerRow& row);
    void flush();
    void trim();

  private:
    std::array<AppendDataset<double>*, 9> columns();

    AppendDataset<double> kinetic_energy_, strain_energy_, external_work_, work_uncertainty_;
    AppendDataset<double> dissipated_energy_, numerical_dissipation_, energy_error_;
    AppendDataset<double> linear_momentum_, angular_momentum_;
};

// /solver: what each step cost, one row a step, after the `rows` that are there. Throws Hdf5Error.
class SolverTable {
  public:
    SolverTable(const Hdf5Handle& solver, bool is_static, hsize_t rows);
    void append(const SolverRow& row);
    void flush();
    void trim();

  private:
    template <class Action>
    void for_each_column(Action&& action);

    AppendDataset<double> time_step_, residual_;
    AppendDataset<std::int64_t> newton_iterations_, rejected_steps_;
    std::optional<AppendDataset<std::int64_t>> negative_pivots_;  // of statics
};

}  // namespace gxrod
