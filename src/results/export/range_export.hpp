#pragma once

#include <filesystem>
#include <vector>

#include "results/export/time_window.hpp"
#include "results/file/output_file.hpp"

namespace gxrod {

// Writes range graphs as CSV: range_ROD.csv of each rod, a row for the middle of each element with the least,
// largest and mean value, over the frames of the window, of tensions, shear force, bending moment and
// curvature, and of stresses if the file has them, and the times of the extremes. `rod` chooses one; "": all.
// Creates the folder if it is missing.
//
// Throws FileError if the results cannot be read, have no such rod, stage or frame in the window, or if a
// file exists and must not be replaced, or cannot be written.
std::vector<std::filesystem::path> export_ranges(const std::filesystem::path& results,
                                                 const std::filesystem::path& folder,
                                                 const std::string& rod,
                                                 const WindowRequest& request,
                                                 Existing existing);

}  // namespace gxrod
