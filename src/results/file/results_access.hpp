#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "results/file/hdf5_reader.hpp"
#include "results/file/output_file.hpp"

namespace gxrod {

// Calls `read` with the results file. If a job that is writing the file has meanwhile moved data that the
// library had cached, reopens it and calls `read` again. So `read` must leave nothing behind when it throws.
// Throws FileError if there is no such file, gxrod did not write it, or it cannot be read; passes on a
// FileError from `read`.
void read_results(const std::filesystem::path& path, const std::function<void(const Hdf5Reader&)>& read);

// Creates the folder if it is missing. Throws FileError if that fails, or as check_export_file does.
void prepare_export(const std::filesystem::path& folder,
                    const std::vector<std::filesystem::path>& files,
                    Existing existing);

}  // namespace gxrod
