#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/export/csv_columns.hpp"
#include "results/export/time_window.hpp"

namespace gxrod {

// A quantity at an end of a line, or the arc length at which it touches the ground: its value when time
// begins, in a run without time its last one, and its range over a window. Angles are in degrees: the
// declination of the axis from start to end from the global z axis, its azimuth from x towards y, within
// half a turn of its first, and where a history of that end has it the angle to the no-load direction.
struct LineEndRow {
    std::string point;     // "riser.end"; the rod for where it touches the ground
    std::string quantity;  // "effective_tension"
    std::string dimension;
    double at_rest = 0.0;  // NaN if there was no rest
    RangeOfNumbers range;
};

// Finds the ends of lines in an open file; empty if it has none. Throws FileError if it has no such stage or
// no step in the window.
std::vector<LineEndRow> find_line_ends(const Hdf5Reader& file,
                                       const std::filesystem::path& results,
                                       const WindowRequest& request);

// Reads the ends of lines that output.line_ends has recorded. Throws FileError if the results cannot be read
// or have none, or no such stage or step in the window.
std::vector<LineEndRow> read_line_ends(const std::filesystem::path& results, const WindowRequest& request);

// Returns the columns of a CSV file.
std::vector<CsvCells> make_columns(const std::vector<LineEndRow>& rows);

// Returns a table to print, without digits that nobody reads.
std::string print_line_ends(const std::vector<LineEndRow>& rows);

}  // namespace gxrod
