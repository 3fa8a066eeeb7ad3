#pragma once

#include <span>
#include <variant>
#include <vector>

#include "results/file/append_dataset.hpp"
#include "results/tables/step_columns.hpp"

namespace gxrod {

// /ledger or /solver: a dataset for each of its columns, one row a step, after the `rows` that exist.
// Instantiated for LedgerRow and SolverRow. Throws Hdf5Error.
template <class Row>
class StepTable {
  public:
    // `columns` must outlive the table.
    StepTable(const Hdf5Handle& group,
              std::span<const StepColumn<Row>> columns,
              bool is_static,
              hsize_t rows);
    void append(const Row& row);
    void flush();
    void trim();

  private:
    struct Column {
        const StepColumn<Row>* form;
        std::variant<AppendDataset<double>, AppendDataset<std::int64_t>> values;
    };
    std::vector<Column> columns_;
};

}  // namespace gxrod
