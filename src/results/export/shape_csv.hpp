#pragma once

#include <filesystem>
#include <string>

#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Writes the table of a stage that found shapes: a row for each shape, its number first and its words last.
// Throws FileError if it cannot be written.
void write_shape_csv(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path);

// Writes the responses of a stage to harmonic forces: a row for each frequency, real and imaginary part of
// each component. Throws FileError if it cannot be written.
void write_response_csv(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path);

// Writes the eigenvalues of a sweep: a row for each value, with columns for each mode. Throws FileError if it
// cannot be written.
void write_sweep_csv(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path);

}  // namespace gxrod
