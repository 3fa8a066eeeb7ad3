#pragma once

#include <filesystem>
#include <string>

#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Writes the table of a group whose datasets have a number or a text for each item. Throws FileError if the
// file cannot be written.
void write_item_csv(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path);

}  // namespace gxrod
