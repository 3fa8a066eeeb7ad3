#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "deck/loads/column_table.hpp"
#include "model/time/time_function.hpp"

namespace gxrod {

// Loads per length at stations of a rod and at times, linear between both. Outside of the stations and the
// times the nearest ones hold.
struct StationLoads {
    std::vector<double> times;                  // rising; one, 0, if the loads do not depend on time
    std::vector<double> stations;               // arc lengths, rising
    std::vector<std::array<double, 6>> values;  // [times][stations]: force along x, y, z, moment about them

    bool has_time() const { return times.size() > 1; }
    // The value of a component.
    double at(std::size_t component, double time, double s) const;
    bool is_zero(std::size_t component) const;
};

inline constexpr std::array<const char*, 6> load_columns{"fx", "fy", "fz", "mx", "my", "mz"};

// Takes loads from a table with columns t, s and those of load_columns that it has, a row for each time and
// station, in any order. Throws FileError.
StationLoads take_rows(const ColumnTable& table, const std::string& file);

// A component of the load in the columns of a file.
struct ColumnPattern {
    std::string text;           // as the deck has it
    double factor = 1.0;        // −1 with a minus before it
    std::string before, after;  // of the number of the station
};

// Splits "-AB1N*Fy". Returns false if it does not have exactly one *.
bool parse_pattern(const std::string& text, ColumnPattern& pattern);

// Takes loads from a table with a column for each component and station: by `patterns`, with an empty text
// where the load has no such component. The first column is the time. Throws FileError.
StationLoads take_columns(const ColumnTable& table,
                          const std::array<ColumnPattern, 6>& patterns,
                          const std::vector<double>& stations,
                          const std::string& file);

// Makes the functions of the components x, y, z of the force, first 0, or of the moment, first 3. `twists`
// and their arc lengths: of the sections, if the components are along axes without their twist; else empty.
struct SectionTwists {
    std::vector<double> arc_lengths, twists;
};
std::array<LineFunction, 3> make_load_functions(const std::shared_ptr<const StationLoads>& loads,
                                                std::size_t first,
                                                const SectionTwists& twists);

}  // namespace gxrod
