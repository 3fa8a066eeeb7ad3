#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gxrod {

// Cells of a small table, held in memory: one or more columns side by side.
struct CsvCells {
    std::vector<std::string> headings;
    std::vector<std::string> cells;  // by rows, as many in each as there are headings
};

CsvCells make_cells(std::vector<std::string> headings, const std::vector<double>& values);
// In quotes where a comma, a quote or a line end asks for them.
CsvCells make_cells(std::string heading, const std::vector<std::string>& texts);

// Writes columns of equally many rows. Throws FileError if the file cannot be written.
void write_csv(const std::filesystem::path& path, const std::vector<CsvCells>& columns);

}  // namespace gxrod
