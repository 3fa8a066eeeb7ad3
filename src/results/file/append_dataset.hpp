#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "results/file/hdf5_objects.hpp"

namespace gxrod {

// The shape of one row of an AppendDataset.
struct RowShape {
    int columns = 1;
    bool is_vector = false;  // rows of [S,columns]; otherwise [S]
};
inline constexpr RowShape scalar_row{1, false};
inline constexpr RowShape vector_row{3, true};

// Largest size of chunks that are not compressed.
inline constexpr std::size_t most_chunk_bytes = 262144;

// Storage of rows on disk.
struct RowChunks {
    hsize_t rows = 0;          // in a chunk; 0: about 4 KiB of them
    bool is_deflated = false;  // if so, rows must come in whole chunks, as no chunk may be written twice
};

// A dataset that grows by rows. Rows are gathered in memory and written by flush(). Instantiated for double
// and std::int64_t. Throws Hdf5Error.
template <class Number>
class AppendDataset {
  public:
    // Opens the dataset of that name and appends after its first `rows` rows; later ones are replaced. A new
    // dataset begins with `rows` rows of NaN (0 for integers).
    AppendDataset(const Hdf5Handle& group,
                  const DatasetLabel& label,
                  RowShape shape,
                  hsize_t rows,
                  RowChunks chunks = {});

    // Appends one row or several: `values` must hold a multiple of the number of columns.
    void append(std::span<const Number> values) {
        buffer_.insert(buffer_.end(), values.begin(), values.end());
    }
    void append(Number value) { buffer_.push_back(value); }
    void flush();
    // Cuts the dataset on disk after its last row.
    void trim();
    // Returns the last row that existed before; empty if there was none.
    std::vector<Number> last_row() const;

    std::size_t buffered_bytes() const { return buffer_.size() * sizeof(Number); }
    hid_t id() const { return dataset_.id(); }

  private:
    void open(const Hdf5Handle& group, const DatasetLabel& label);
    void create(const Hdf5Handle& group, const DatasetLabel& label, RowChunks chunks);
    void set_extent(hsize_t rows);

    Hdf5Handle dataset_;
    RowShape shape_;
    hsize_t rows_;        // written
    hsize_t extent_ = 0;  // rows on disk, with rows to be replaced and rows of chunks beyond the end
    std::vector<Number> buffer_;
};

}  // namespace gxrod
