#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/file/output_file.hpp"

namespace gxrod {

// Which rod to export, and which frames.
struct AlongRod {
    std::string rod;
    std::optional<double> time;  // for the frame nearest to it; without it the last one
    bool all_frames = false;
};

struct AlongExport {
    std::vector<std::filesystem::path> files;
    std::vector<double> times;  // of the frames written
};

// Writes the frames' values along a rod as CSV, with all digits: along_ROD_nodes.csv, a row for each node,
// and along_ROD_elements.csv, a row for the middle of each element, from the rod's start to its end, frame
// after frame. Creates the folder if it is missing.
//
// Throws FileError if the results cannot be read, have no such rod or no frame near the time, or a file
// exists and is not to be replaced, or cannot be written.
AlongExport export_along(const std::filesystem::path& results,
                         const std::filesystem::path& folder,
                         const AlongRod& request,
                         Existing existing);

}  // namespace gxrod
