#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "results/file/hdf5_reader.hpp"
#include "results/file/output_file.hpp"

namespace gxrod {

// Calls `read` with the results file, and again with the file reopened if a job that writes it meanwhile
// moved what the library had cached. So `read` can be called several times, and must not leave anything
// behind when it throws. Throws FileError if there is no such file, it is not one of gxrod's, or it cannot be
// read; a FileError from `read` is passed on.
void read_results(const std::filesystem::path& path, const std::function<void(const Hdf5Reader&)>& read);

// Creates the folder if it is missing. Throws FileError if that fails, or as check_export_file does.
void prepare_export(const std::filesystem::path& folder,
                    const std::vector<std::filesystem::path>& files,
                    Existing existing);

}  // namespace gxrod
