#include "deck/loads/station_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "machine/file_error.hpp"

namespace gxrod {
namespace {

// Bracket which two entries a value lies, and how far from the first one.
struct Bracket {
    std::size_t first = 0;
    double share = 0.0;  // of the second one
};

Bracket find_bracket(const std::vector<double>& rising, double value) {
    if (rising.size() < 2 || value <= rising.front()) return {};
    if (value >= rising.back()) return {rising.size() - 2, 1.0};
    const auto above = std::ranges::upper_bound(rising, value) - rising.begin();
    const auto first = static_cast<std::size_t>(above) - 1;
    return {first, (value - rising[first]) / (rising[first + 1] - rising[first])};
}

double interpolate_rows(const std::vector<double>& at, const std::vector<double>& values, double where) {
    const Bracket between = find_bracket(at, where);
    if (between.share == 0.0) return values[between.first];
    return (1.0 - between.share) * values[between.first] + between.share * values[between.first + 1];
}

std::optional<std::size_t> find_column_named(const ColumnTable& table, std::string_view name) {
    const auto found = std::ranges::find(table.names, name);
    if (found == table.names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - table.names.begin());
}

std::vector<double> sorted_column(const ColumnTable& table, std::size_t column) {
    std::vector<double> values;
    for (std::size_t row = 0; row < table.rows(); ++row) values.push_back(table.at(row, column));
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::size_t index_in_column(const std::vector<double>& sorted, double value) {
    return static_cast<std::size_t>(std::ranges::lower_bound(sorted, value) - sorted.begin());
}

void check_station_names(const ColumnTable& table, const std::string& file) {
    for (const std::string& name : table.names) {
        if (name == "t" || name == "s" || std::ranges::find(load_columns, name) != load_columns.end())
            continue;
        throw FileError(
            file,
            fmt::format("has a column \"{}\"; expected t, s, fx, fy, fz, mx, my, mz, or `columns` that "
                        "names those of each station",
                        name));
    }
}

// The columns that fit a pattern, by the number in the place of the *.
std::map<long, std::size_t> find_station_columns(const ColumnTable& table, const ColumnPattern& pattern) {
    std::map<long, std::size_t> found;
    for (std::size_t i = 0; i < table.columns(); ++i) {
        const std::string& name = table.names[i];
        if (name.size() <= pattern.before.size() + pattern.after.size() ||
            !name.starts_with(pattern.before) || !name.ends_with(pattern.after))
            continue;
        const std::string number =
            name.substr(pattern.before.size(), name.size() - pattern.before.size() - pattern.after.size());
        if (number.size() < 9 && std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; }))
            found.emplace(std::stol(number), i);
    }
    return found;
}

void check_rising_times(const ColumnTable& table, const std::string& file) {
    if (table.rows() == 0) throw FileError(file, "has no rows of numbers");
    for (std::size_t row = 1; row < table.rows(); ++row) {
        if (table.at(row, 0) > table.at(row - 1, 0)) continue;
        throw FileError(table.place_of(row, file),
                        fmt::format("expected a time after {}, that of the row before, found {}",
                                    table.at(row - 1, 0),
                                    table.at(row, 0)));
    }
}

}  // namespace

double StationLoads::at(std::size_t component, double time, double s) const {
    const Bracket place = find_bracket(stations, s), moment = find_bracket(times, time);
    const auto row = [&](std::size_t number) {
        const auto* values_then = &values[number * stations.size() + place.first];
        if (place.share == 0.0) return values_then[0][component];
        return (1.0 - place.share) * values_then[0][component] + place.share * values_then[1][component];
    };
    if (moment.share == 0.0) return row(moment.first);
    return (1.0 - moment.share) * row(moment.first) + moment.share * row(moment.first + 1);
}

bool StationLoads::is_zero(std::size_t component) const {
    return std::ranges::all_of(values, [&](const auto& one) { return one[component] == 0.0; });
}

StationLoads take_rows(const ColumnTable& table, const std::string& file) {
    check_station_names(table, file);
    const auto time = find_column_named(table, "t"), place = find_column_named(table, "s");
    if (!place) throw FileError(file, "has no column s, the arc length of a station from the rod's start");
    if (table.rows() == 0) throw FileError(file, "has no rows of numbers");
    StationLoads loads{.times = time ? sorted_column(table, *time) : std::vector<double>{0.0},
                       .stations = sorted_column(table, *place),
                       .values = {}};
    loads.values.resize(loads.times.size() * loads.stations.size());
    std::vector<bool> is_given(loads.values.size());
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double t = time ? table.at(row, *time) : 0.0, s = table.at(row, *place);
        const std::size_t entry =
            index_in_column(loads.times, t) * loads.stations.size() + index_in_column(loads.stations, s);
        if (is_given[entry])
            throw FileError(table.place_of(row, file),
                            fmt::format("a row before it has t = {}, s = {} too", t, s));
        is_given[entry] = true;
        for (std::size_t i = 0; i < 6; ++i) {
            const auto column = find_column_named(table, load_columns[i]);
            loads.values[entry][i] = column ? table.at(row, *column) : 0.0;
        }
    }
    const auto gap = std::ranges::find(is_given, false) - is_given.begin();
    if (gap < static_cast<std::ptrdiff_t>(is_given.size())) {
        const std::size_t entry = static_cast<std::size_t>(gap), count = loads.stations.size();
        throw FileError(
            file,
            fmt::format("has no row for t = {}, s = {}; expected one for each time with each station",
                        loads.times[entry / count],
                        loads.stations[entry % count]));
    }
    return loads;
}

bool parse_pattern(const std::string& text, ColumnPattern& pattern) {
    const std::size_t start = text.starts_with('-') ? 1 : 0;
    const std::size_t star = text.find('*');
    if (star == std::string::npos || text.find('*', star + 1) != std::string::npos) return false;
    pattern = {text, start == 1 ? -1.0 : 1.0, text.substr(start, star - start), text.substr(star + 1)};
    return true;
}

StationLoads take_columns(const ColumnTable& table,
                          const std::array<ColumnPattern, 6>& patterns,
                          const std::vector<double>& stations,
                          const std::string& file) {
    check_rising_times(table, file);
    StationLoads loads{.times = {}, .stations = stations, .values = {}};
    for (std::size_t row = 0; row < table.rows(); ++row) loads.times.push_back(table.at(row, 0));
    loads.values.resize(loads.times.size() * stations.size());
    for (std::size_t i = 0; i < 6; ++i) {
        if (patterns[i].text.empty()) continue;
        const std::map<long, std::size_t> columns = find_station_columns(table, patterns[i]);
        if (columns.size() != stations.size())
            throw FileError(file,
                            fmt::format("has {} columns \"{}*{}\" for {}, and `stations` has {} entries",
                                        columns.size(),
                                        patterns[i].before,
                                        patterns[i].after,
                                        load_columns[i],
                                        stations.size()));
        std::size_t station = 0;
        for (const auto& [number, column] : columns) {
            for (std::size_t row = 0; row < table.rows(); ++row)
                loads.values[row * stations.size() + station][i] = patterns[i].factor * table.at(row, column);
            ++station;
        }
    }
    return loads;
}

std::array<LineFunction, 3> make_load_functions(const std::shared_ptr<const StationLoads>& loads,
                                                std::size_t first,
                                                const SectionTwists& twists) {
    auto switches = std::make_shared<Switches>();
    if (loads->stations.size() > 1)
        switches->push_back({[](double, double s) { return s; }, loads->stations, false, true, true});
    if (loads->has_time())
        switches->push_back({[](double t, double) { return t; }, loads->times, true, false, true});
    const LineForm form{loads->has_time() ? InTime::varying : InTime::constant, false};
    const bool turns = std::ranges::any_of(twists.twists, [](double twist) { return twist != 0.0; });
    std::array<LineFunction, 3> functions;
    for (std::size_t i = 0; i < 3; ++i) {
        const bool is_across = turns && i > 0;
        const std::size_t own = first + i, other = is_across ? first + 3 - i : own;
        if (loads->is_zero(own) && loads->is_zero(other)) continue;
        if (!is_across) {
            functions[i] = LineFunction(
                [loads, own](double t, double s) { return loads->at(own, t, s); }, switches, form);
            continue;
        }
        // The section's axes are turned by the twist about x: y gets cos y + sin z, z gets cos z − sin y.
        const double sign = i == 1 ? 1.0 : -1.0;
        functions[i] = LineFunction(
            [loads, own, other, sign, twists](double t, double s) {
                const double twist = interpolate_rows(twists.arc_lengths, twists.twists, s);
                return std::cos(twist) * loads->at(own, t, s) +
                       sign * std::sin(twist) * loads->at(other, t, s);
            },
            switches,
            form);
    }
    return functions;
}

}  // namespace gxrod
