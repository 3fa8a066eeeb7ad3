#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gxrod {

struct CsvRow {
    int line = 0;  // where it begins, from 1
    std::vector<std::string> fields;
};

// The rows of a CSV text as RFC 4180 has it; fields can be quoted and then hold commas, quotes (doubled) and
// line ends. Empty lines are left out. A last row without its line end is given too. Throws FileError, which
// names `file` and the line, where a quote is out of place.
std::vector<CsvRow> read_csv(std::string_view text, const std::filesystem::path& file);

// A field as it is in a row.
std::string write_csv_field(std::string_view field);

}  // namespace gxrod
