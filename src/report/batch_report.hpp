#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "report/case_pages.hpp"
#include "results/file/output_file.hpp"

namespace gxrod {

struct BatchReportOptions {
    std::filesystem::path folder;
    std::filesystem::path page;
    std::size_t most_bytes = 20'000'000;      // largest size of the page
    std::size_t most_case_bytes = 3'000'000;  // largest size of each case's page
    Existing existing = Existing::refuse;     // for the page; pages of cases are replaced if they are older
    CaseChoice cases = {};
    PageProgress progress = [](std::size_t, std::size_t) {};
};

struct BatchReportSummary {
    std::size_t bytes = 0;              // size of the page
    std::size_t finished = 0;           // cases in the table
    long cases = 0;                     // cases of the batch
    std::vector<std::string> left_out;  // parts omitted to stay within most_bytes, a sentence each
    CasePages pages;
};

// Writes one HTML page that shows a batch, or the part so far of a running one: a table of its cases, charts
// of the collected values over the parameters, plan and decks. Also writes pages of its cases, to which it
// links by relative addresses.
//
// Throws FileError if the folder does not hold a batch, its files cannot be read, the page exists and must
// not be replaced or cannot be written, or most_bytes is too small.
BatchReportSummary write_batch_report(const BatchReportOptions& options);

// Returns the address of a folder, with "/" at its end, for a link of a page: relative, and encoded as in
// URLs.
std::string relative_address(const std::filesystem::path& folder, const std::filesystem::path& page);

}  // namespace gxrod
