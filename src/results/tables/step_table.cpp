#include "results/tables/step_table.hpp"

namespace gxrod {
namespace {

template <class Row>
bool is_whole(const StepColumn<Row>& column) {
    return std::holds_alternative<int Row::*>(column.member) ||
           std::holds_alternative<std::int64_t Row::*>(column.member);
}

}  // namespace

template <class Row>
StepTable<Row>::StepTable(const Hdf5Handle& group,
                          std::span<const StepColumn<Row>> columns,
                          bool is_static,
                          hsize_t rows) {
    for (const StepColumn<Row>& column : columns) {
        if (column.is_of_statics && !is_static) continue;
        const DatasetLabel label{column.name, column.description, column.frame(), column.dimension};
        const RowShape shape = column.width() == 3 ? vector_row : scalar_row;
        if (is_whole(column)) {
            columns_.push_back({&column, AppendDataset<std::int64_t>(group, label, shape, rows)});
        } else {
            columns_.push_back({&column, AppendDataset<double>(group, label, shape, rows)});
        }
    }
}

template <class Row>
void StepTable<Row>::append(const Row& row) {
    for (Column& column : columns_) {
        const std::array<double, 3> numbers = numbers_of(*column.form, row);
        if (auto* whole = std::get_if<AppendDataset<std::int64_t>>(&column.values)) {
            whole->append(static_cast<std::int64_t>(numbers[0]));
        } else {
            std::get<AppendDataset<double>>(column.values)
                .append(std::span(numbers).first(static_cast<std::size_t>(column.form->width())));
        }
    }
}

template <class Row>
void StepTable<Row>::flush() {
    for (Column& column : columns_) std::visit([](auto& values) { values.flush(); }, column.values);
}

template <class Row>
void StepTable<Row>::trim() {
    for (Column& column : columns_) std::visit([](auto& values) { values.trim(); }, column.values);
}

template class StepTable<LedgerRow>;
template class StepTable<SolverRow>;

}  // namespace gxrod
