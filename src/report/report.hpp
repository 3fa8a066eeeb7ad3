#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "results/file/output_file.hpp"

namespace gxrod {

struct ReportOptions {
    std::filesystem::path results;
    std::filesystem::path page;
    std::size_t most_bytes = 20'000'000;  // largest size of the page
    Existing existing = Existing::refuse;
};

struct ReportSummary {
    std::size_t bytes = 0;              // size of the page
    std::vector<std::string> left_out;  // parts omitted to stay within most_bytes, a sentence each
    std::vector<std::string> warnings;  // warnings of the run, as on the page
};

// Writes one HTML page that shows the results of a run, or the results so far of a running job: the motion in
// 3D, charts of every history, the deck and the model. The page needs no other file and no network.
//
// Frames and steps are read a few at a time. Throws FileError if the results cannot be read, the page exists
// and must not be replaced, is the results file itself or cannot be written, or most_bytes is too small.
ReportSummary write_report(const ReportOptions& options);

}  // namespace gxrod
