#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gxrod {

// Numbers in columns with names.
struct ColumnTable {
    std::vector<std::string> names;
    std::vector<double> values;  // [rows][columns]
    std::vector<int> lines;      // of the rows in the file; empty for a binary one

    std::size_t columns() const { return names.size(); }
    std::size_t rows() const { return names.empty() ? 0 : values.size() / names.size(); }
    double at(std::size_t row, std::size_t column) const { return values[row * names.size() + column]; }
    // The place of a row in the file, for messages: "aero.csv:12", "aero.outb: row 3".
    std::string place_of(std::size_t row, const std::string& file) const;
};

// Reads the output of OpenFAST, as text (.out) or binary (.outb, formats 1 to 4), or a CSV file with a
// header. Throws FileError whose text begins with the file, and the line of a text.
ColumnTable read_column_table(std::string_view bytes, const std::string& file);

}  // namespace gxrod
