#include "results/tables/input_table.hpp"

#include "results/file/hdf5_objects.hpp"

namespace gxrod {

InputTable::InputTable(const Hdf5Handle& root,
                       const std::vector<std::shared_ptr<Input>>& inputs,
                       hsize_t rows) {
    if (inputs.empty()) return;
    const Hdf5Handle group = require_group(root, "inputs");
    for (const std::shared_ptr<Input>& input : inputs)
        values_.emplace_back(
            group, DatasetLabel{input->name(), "value of the input", "none", ""}, scalar_row, rows);
}

void InputTable::append(std::span<const double> values) {
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i].append(values.subspan(i, 1));
}

void InputTable::flush() {
    for (AppendDataset<double>& values : values_) values.flush();
}

void InputTable::trim() {
    for (AppendDataset<double>& values : values_) values.trim();
}

}  // namespace gxrod
