#pragma once

#include <filesystem>
#include <vector>

#include "results/file/output_file.hpp"

namespace gxrod {

// Writes the tables of a results file as CSV: ledger.csv, solver.csv, history_NAME.csv for each history and
// stage_NAME.csv for each stage that found shapes. Creates the folder if it is missing. The first column is
// the time, or the load factor of a static run; vectors have columns for x, y, z, quaternions for w, x, y, z,
// all with all digits. If the job is still running, writes the steps so far. Returns the files.
//
// Throws FileError if the results cannot be read, or if a file exists and must not be replaced, or cannot be
// written.
std::vector<std::filesystem::path> export_csv(const std::filesystem::path& results,
                                              const std::filesystem::path& folder,
                                              Existing existing);

}  // namespace gxrod
