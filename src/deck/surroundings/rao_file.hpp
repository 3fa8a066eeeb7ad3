#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace gxrod {

// A row of a file of response amplitude operators.
struct RaoRow {
    double frequency;                              // rad a time
    double heading;                                // degrees
    std::array<double, 6> amplitudes{}, phases{};  // as the file has them; phases in degrees
};

// Reads a CSV file whose header names its columns: period or frequency, heading, and of surge, sway, heave,
// roll, pitch and yaw those that the file has, each with a column like surge_phase. The rows are a grid: each
// heading with each frequency, sorted by both. Throws FileError whose text begins with "file:line".
std::vector<RaoRow> read_raos(std::string_view bytes, const std::string& file);

}  // namespace gxrod
