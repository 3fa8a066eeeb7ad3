#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "results/file/hdf5_reader.hpp"
#include "results/file/output_file.hpp"

// What all that reads results to write them in another form has in common.
namespace gxrod {

// Calls `read` with the results file; once more, the file opened anew, where a job that writes it meanwhile
// moved what the library remembers of it. So `read` may be called several times, and must not leave anything
// behind when it throws. Throws FileError if there is no such file, it is not one of gxrod's, or cannot be
// read; a FileError of `read` ends it.
void read_results(const std::filesystem::path& path, const std::function<void(const Hdf5Reader&)>& read);

// Makes the folder, if need be. Throws FileError if that fails, or as check_export_file does.
void prepare_export(const std::filesystem::path& folder,
                    const std::vector<std::filesystem::path>& files,
                    Existing existing);

}  // namespace gxrod
