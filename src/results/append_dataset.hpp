#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "results/hdf5_objects.hpp"

namespace gxrod {

// Form of one row of an AppendDataset.
struct RowShape {
    int columns = 1;
    bool is_vector = false;  // rows of [S,columns]; otherwise [S]
};
inline constexpr RowShape scalar_row{1, false};
inline constexpr RowShape vector_row{3, true};

// A dataset that grows by rows. Rows are gathered in memory and written by flush(), in chunks of about
// `chunk_bytes`. Instantiated for double and std::int64_t. Throws Hdf5Error.
template <class Number>
class AppendDataset {
  public:
    AppendDataset(const Hdf5Handle& group,
                  const DatasetLabel& label,
                  RowShape shape,
                  std::size_t chunk_bytes = 4096);

    // One row or several: a multiple of the number of columns.
    void append(std::span<const Number> values) {
        buffer_.insert(buffer_.end(), values.begin(), values.end());
    }
    void append(Number value) { buffer_.push_back(value); }
    void flush();

    std::size_t buffered_bytes() const { return buffer_.size() * sizeof(Number); }
    hid_t id() const { return dataset_.id(); }

  private:
    Hdf5Handle dataset_;
    RowShape shape_;
    hsize_t rows_ = 0;  // in the file
    std::vector<Number> buffer_;
};

}  // namespace gxrod
