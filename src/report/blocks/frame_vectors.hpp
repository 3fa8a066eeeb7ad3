#pragma once

#include <span>
#include <string>
#include <vector>

#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// One quantity of the frames, three numbers a row, read in order: small frames many at once, so that a frame
// costs no call of HDF5 of its own. Throws Hdf5Error.
class FrameVectors {
  public:
    // `rows` a frame; `frames` is the number of those that may be asked for.
    FrameVectors(const Hdf5Reader& file, std::string dataset, std::size_t rows, std::size_t frames)
        : file_(file), dataset_(std::move(dataset)), rows_(rows), frames_(frames) {}

    // All rows of a frame; valid until the next call. The frames asked for never decrease.
    std::span<const double> read(std::size_t frame);

  private:
    const Hdf5Reader& file_;
    std::string dataset_;
    std::size_t rows_, frames_;
    std::size_t first_ = 0, end_ = 0;  // frames that are in memory
    std::vector<double> values_;
};

}  // namespace gxrod
