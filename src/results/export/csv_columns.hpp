#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gxrod {

// One or more columns of a small table in memory.
struct CsvCells {
    std::vector<std::string> headings;
    std::vector<std::string> cells;  // row by row, one for each heading
};

CsvCells make_cells(std::vector<std::string> headings, const std::vector<double>& values);
// Makes a column; a text with a comma, a quote or a line end is put in quotes.
CsvCells make_cells(std::string heading, const std::vector<std::string>& texts);

// Writes columns of equally many rows. Throws FileError if the file cannot be written.
void write_csv(const std::filesystem::path& path, const std::vector<CsvCells>& columns);

}  // namespace gxrod
