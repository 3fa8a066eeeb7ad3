#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gxrod {

struct CsvRow {
    int line = 0;  // line at which it begins, from 1
    std::vector<std::string> fields;
};

// Reads the rows of a CSV text (RFC 4180); quoted fields can hold commas, quotes (doubled) and line ends.
// Skips empty lines. The last row may lack its line end. Throws FileError, which names `file` and the line,
// if a quote is misplaced.
std::vector<CsvRow> read_csv(std::string_view text, const std::filesystem::path& file);

// Writes a field as it stands in a row.
std::string write_csv_field(std::string_view field);

}  // namespace gxrod
