#pragma once

#include <span>
#include <string>
#include <vector>

#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Reads one quantity of the frames, `width` numbers a row, in order. Many small frames are read at once, to
// save calls of HDF5. Throws Hdf5Error.
class FrameVectors {
  public:
    // Each frame has `rows` rows; only the first `frames` frames can be read.
    FrameVectors(const Hdf5Reader& file,
                 std::string dataset,
                 std::size_t rows,
                 std::size_t frames,
                 std::size_t width = 3)
        : file_(file), dataset_(std::move(dataset)), rows_(rows), frames_(frames), width_(width) {}

    // Returns all rows of a frame; valid until the next call. Frames must be read in ascending order.
    std::span<const double> read(std::size_t frame);

  private:
    const Hdf5Reader& file_;
    std::string dataset_;
    std::size_t rows_, frames_, width_;
    std::size_t first_ = 0, end_ = 0;  // range of frames in memory
    std::vector<double> values_;
};

}  // namespace gxrod
