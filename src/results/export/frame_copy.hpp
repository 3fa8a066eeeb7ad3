#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
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

// Copies rows of a dataset. Throws Hdf5Error, or std::runtime_error if there is no such dataset.
DatasetCopy copy_rows(const Hdf5Reader& file, const std::string& path, hsize_t first, hsize_t count);
// Makes a dataset of integers with this size in each direction.
DatasetCopy make_copy(const std::string& path,
                      const std::string& description,
                      std::vector<hsize_t> size,
                      const std::vector<std::int64_t>& values);

// Makes datasets of floating-point numbers, and of bytes.
DatasetCopy make_copy(const std::string& path,
                      const std::string& description,
                      std::vector<hsize_t> size,
                      const std::vector<float>& values);
DatasetCopy make_copy(const std::string& path,
                      const std::string& description,
                      std::vector<hsize_t> size,
                      const std::vector<std::uint8_t>& values);

// Type and version that tell VTK how to read a file.
struct VtkForm {
    std::string type;
    std::int64_t version = 1;
    std::optional<std::int64_t> steps{};  // number of complete ones, for a file with times
};
// Writes datasets of /VTKHDF as a separate file, or over an existing one. Throws FileError.
void write_copies(const FrameCopy& copies, const VtkForm& form, const std::filesystem::path& path);

// Reads a frame. Throws Hdf5Error or std::runtime_error if the file cannot be read or has no such frame.
FrameCopy read_frame(const Hdf5Reader& results, hsize_t frame);

}  // namespace gxrod
