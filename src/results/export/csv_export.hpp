#pragma once

#include <filesystem>
#include <vector>

#include "results/file/output_file.hpp"

namespace gxrod {

// Writes the tables of a results file as CSV: ledger.csv, solver.csv, history_NAME.csv for each history and
// stage_NAME.csv of each stage that found shapes, in a folder that is created if it is missing. The first
// column is the time, or the load factor of a static run; vectors have columns for x, y, z, quaternions for
// w, x, y, z, all with all digits. Of a running job, the steps so far. Returns the files.
//
// Throws FileError if the results cannot be read, or a file exists and is not to be replaced, or cannot be
// written.
std::vector<std::filesystem::path> export_csv(const std::filesystem::path& results,
                                              const std::filesystem::path& folder,
                                              Existing existing);

}  // namespace gxrod
