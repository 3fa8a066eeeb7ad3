#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/file/output_file.hpp"

namespace gxrod {

// The rod and the frames to export.
struct AlongRod {
    std::string rod;
    std::optional<double> time;  // time of the frame, about; without it the last frame
    bool all_frames = false;
};

struct AlongExport {
    std::vector<std::filesystem::path> files;
    std::vector<double> times;  // times of the frames that were written
};

// Writes the frames' values along a rod as CSV, with all digits: along_ROD_nodes.csv, a row for each node,
// and along_ROD_elements.csv, a row for the middle of each element, from the rod's start to its end, frame
// after frame. Creates the folder if it is missing.
//
// Throws FileError if the results cannot be read, have no such rod or no frame near the time, or if a file
// exists and must not be replaced, or cannot be written.
AlongExport export_along(const std::filesystem::path& results,
                         const std::filesystem::path& folder,
                         const AlongRod& request,
                         Existing existing);

}  // namespace gxrod
