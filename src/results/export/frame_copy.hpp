#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "results/file/hdf5_objects.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Rows of a dataset in memory, bit for bit as in the file.
struct DatasetCopy {
    std::string path;
    DatasetLabel label;
    Hdf5Handle type;
    std::vector<hsize_t> size;
    std::vector<std::byte> bytes;
};

// A frame of results: topology, points, and all point and cell data.
using FrameCopy = std::vector<DatasetCopy>;

// Throws Hdf5Error or std::runtime_error if the file cannot be read, or has no such frame.
FrameCopy read_frame(const Hdf5Reader& results, hsize_t frame);

// Writes the frame as a file of its own, a VTKHDF 1.0 unstructured grid without times. Overwrites.
// Throws FileError.
void write_frame(const FrameCopy& frame, const std::filesystem::path& path);

}  // namespace gxrod
