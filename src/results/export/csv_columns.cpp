#include "results/export/csv_columns.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "machine/file_error.hpp"

namespace gxrod {
namespace {

std::string quote(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + "\"";
}

void write_row(const std::vector<CsvCells>& columns,
               const std::vector<std::string> CsvCells::*texts,
               std::size_t row,
               std::ostream& out) {
    const char* separator = "";
    for (const CsvCells& column : columns) {
        const std::size_t width = column.headings.size();
        for (std::size_t i = 0; i < width; ++i) {
            out << separator << (column.*texts).at(row * width + i);
            separator = ",";
        }
    }
    out << '\n';
}

}  // namespace

CsvCells make_cells(std::vector<std::string> headings, const std::vector<double>& values) {
    CsvCells column{std::move(headings), {}};
    for (const double value : values) column.cells.push_back(fmt::format("{}", value));
    return column;
}

CsvCells make_cells(std::string heading, const std::vector<std::string>& texts) {
    CsvCells column{{std::move(heading)}, {}};
    for (const std::string& text : texts) column.cells.push_back(quote(text));
    return column;
}

void write_csv(const std::filesystem::path& path, const std::vector<CsvCells>& columns) {
    std::ofstream out(path, std::ios::binary);
    write_row(columns, &CsvCells::headings, 0, out);
    const std::size_t rows =
        columns.empty() ? 0 : columns.front().cells.size() / columns.front().headings.size();
    for (std::size_t row = 0; row < rows; ++row) write_row(columns, &CsvCells::cells, row, out);
    out.close();
    if (!out) throw FileError(path, "cannot be written", std::generic_category().message(errno));
}

}  // namespace gxrod
