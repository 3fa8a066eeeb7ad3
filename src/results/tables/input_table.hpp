#pragma once

#include <memory>
#include <span>
#include <vector>

#include "model/time/input.hpp"
#include "results/file/append_dataset.hpp"

namespace gxrod {

// /inputs/<name>: the value of each input at each step. Throws Hdf5Error.
class InputTable {
  public:
    // Appends after the `rows` that exist. Without inputs there is no group.
    InputTable(const Hdf5Handle& root, const std::vector<std::shared_ptr<Input>>& inputs, hsize_t rows);

    void append(std::span<const double> values);
    void flush();
    void trim();

  private:
    std::vector<AppendDataset<double>> values_;
};

}  // namespace gxrod
