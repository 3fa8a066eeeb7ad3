#pragma once

#include <filesystem>

#include "results/file/output_file.hpp"

namespace gxrod {

// Writes the largest stresses of all steps along all rods as envelopes.csv: rod, element, arc length and
// section of each place, then of the von Mises stress and of the exposure the value, its time, y, z and layer
// in the section, and the six resultants there. Creates the folder if it is missing. If the job is still
// running, writes those so far. Returns the file.
//
// Throws FileError if the results cannot be read or have no stresses, or if the file exists and must not be
// replaced, or cannot be written.
std::filesystem::path export_envelopes(const std::filesystem::path& results,
                                       const std::filesystem::path& folder,
                                       Existing existing);

}  // namespace gxrod
