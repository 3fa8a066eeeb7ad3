#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/file/output_file.hpp"

namespace gxrod {

// What to write of a rod: of one frame or of all.
struct AlongRod {
    std::string rod;
    std::optional<double> time;  // the frame nearest to it; the last one if there is none
    bool all_frames = false;
};

struct AlongExport {
    std::vector<std::filesystem::path> files;
    std::vector<double> times;  // of the frames written
};

// Writes what frames have along a rod as CSV, with all digits of their numbers: along_ROD_nodes.csv, a row
// for each node, and along_ROD_elements.csv, a row for the middle of each element, from the rod's start to
// its end, frame after frame. The folder is made if need be.
//
// Throws FileError if the results cannot be read, have no such rod or no frame near the time, or a file
// exists and is not to be replaced, or cannot be written.
AlongExport export_along(const std::filesystem::path& results,
                         const std::filesystem::path& folder,
                         const AlongRod& request,
                         Existing existing);

}  // namespace gxrod
