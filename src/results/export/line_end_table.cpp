#include "results/export/line_end_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "machine/file_error.hpp"
#include "results/file/results_access.hpp"

namespace gxrod {
namespace {

constexpr const char* end_quantities[]{"effective_tension", "wall_tension", "shear_force", "bending_moment"};
constexpr const char* ground_quantities[]{"touch_down_start", "touch_down_end"};
constexpr double degrees_of_radian = 180.0 / std::numbers::pi;
constexpr double least_level = 1e-9;  // of an axis of length 1; below, it is upright and has no azimuth

struct WindowRows {
    std::vector<double> times;
    std::vector<std::size_t> rows;
    std::optional<std::size_t> rest;  // the last row before time passes
};

WindowRows find_rows(const Hdf5Reader& file,
                     const std::filesystem::path& results,
                     const WindowRequest& request) {
    WindowRows found;
    found.times = file.numbers("/histories/time");
    found.rows = list_rows(found.times, find_window(file, results, request));
    if (is_of_load_factors(file)) {
        found.rest = found.times.size() - 1;
    } else {
        for (std::size_t row = 0; row < found.times.size() && found.times[row] <= 0.0; ++row)
            found.rest = row;
    }
    return found;
}

LineEndRow make_row(const WindowRows& window, const std::vector<double>& values) {
    LineEndRow row;
    row.at_rest = window.rest && *window.rest < values.size() ? values[*window.rest]
                                                              : std::numeric_limits<double>::quiet_NaN();
    for (const std::size_t i : window.rows) {
        if (i < values.size()) row.range.add(window.times[i], values[i]);
    }
    return row;
}

std::vector<double> find_declinations(const std::vector<double>& axes) {
    std::vector<double> angles;
    for (std::size_t i = 0; i + 2 < axes.size(); i += 3)
        angles.push_back(degrees_of_radian * std::atan2(std::hypot(axes[i], axes[i + 1]), axes[i + 2]));
    return angles;
}

// Within half a turn of the first one.
std::vector<double> find_azimuths(const std::vector<double>& axes) {
    std::vector<double> angles;
    std::optional<double> first;
    for (std::size_t i = 0; i + 2 < axes.size(); i += 3) {
        if (!(std::hypot(axes[i], axes[i + 1]) > least_level)) {
            angles.push_back(std::numeric_limits<double>::quiet_NaN());
            continue;
        }
        const double angle = degrees_of_radian * std::atan2(axes[i + 1], axes[i]);
        if (!first) first = angle;
        angles.push_back(angle - 360.0 * std::round((angle - *first) / 360.0));
    }
    return angles;
}

bool is_touch_down(const Hdf5Reader& file, const std::string& group) {
    return file.has(group + "/" + ground_quantities[0]) && file.has(group + "/" + ground_quantities[1]);
}

bool is_line_end(const Hdf5Reader& file, const std::string& group) {
    const std::string at = file.text_attribute(group, "at");
    return (at.ends_with(".start") || at.ends_with(".end")) && file.has(group + "/axis_x") &&
           file.has(group + "/effective_tension");
}

// Rod by rod, its start first, where it lies on the ground last.
std::vector<std::string> list_line_ends(const Hdf5Reader& file) {
    std::vector<std::pair<std::string, std::string>> found;  // by what sorts them
    for (const std::string& name : file.members("/histories")) {
        const std::string group = "/histories/" + name;
        if (!file.has_attribute(group, "at")) continue;
        const std::string at = file.text_attribute(group, "at");
        if (is_touch_down(file, group)) found.emplace_back(at + " 2", group);
        if (is_line_end(file, group))
            found.emplace_back(at.substr(0, at.rfind('.')) + (at.ends_with(".start") ? " 0" : " 1"), group);
    }
    std::ranges::sort(found);
    std::vector<std::string> groups;
    for (const auto& [key, group] : found) groups.push_back(group);
    return groups;
}

void add_line_end(const Hdf5Reader& file,
                  const std::string& group,
                  const WindowRows& window,
                  std::vector<LineEndRow>& rows) {
    const auto add = [&](const std::string& quantity, const std::string& dimension, const auto& values) {
        rows.push_back(make_row(window, values));
        rows.back().point = file.text_attribute(group, "at");
        rows.back().quantity = quantity;
        rows.back().dimension = dimension;
    };
    const auto add_all = [&](std::span<const char* const> quantities) {
        for (const char* quantity : quantities) {
            const std::string path = group + "/" + quantity;
            if (file.has(path)) add(quantity, file.text_attribute(path, "dimension"), file.numbers(path));
        }
    };
    if (is_touch_down(file, group)) return add_all(ground_quantities);
    add_all(end_quantities);
    const std::vector<double> axes = file.numbers(group + "/axis_x");
    add("declination", "deg", find_declinations(axes));
    add("azimuth", "deg", find_azimuths(axes));
    const std::string no_load = group + "/no_load_angle";
    if (!file.has(no_load)) return;
    std::vector<double> angles = file.numbers(no_load);
    for (double& angle : angles) angle *= degrees_of_radian;
    add("no_load_angle", "deg", angles);
}

std::string print_number(double number) { return std::isnan(number) ? "-" : fmt::format("{:.6g}", number); }

}  // namespace

std::vector<LineEndRow> find_line_ends(const Hdf5Reader& file,
                                       const std::filesystem::path& results,
                                       const WindowRequest& request) {
    const std::vector<std::string> groups = list_line_ends(file);
    if (groups.empty()) return {};
    const WindowRows window = find_rows(file, results, request);
    std::vector<LineEndRow> rows;
    for (const std::string& group : groups) add_line_end(file, group, window, rows);
    return rows;
}

std::vector<LineEndRow> read_line_ends(const std::filesystem::path& results, const WindowRequest& request) {
    std::vector<LineEndRow> rows;
    read_results(results, [&](const Hdf5Reader& file) { rows = find_line_ends(file, results, request); });
    if (rows.empty())
        throw FileError(
            results, "has no ends of lines", "run it with line_ends = [\"ROD\", …] in [output] of the deck");
    return rows;
}

std::vector<CsvCells> make_columns(const std::vector<LineEndRow>& rows) {
    std::vector<CsvCells> columns;
    const auto add_texts = [&](const char* heading, std::string LineEndRow::*text) {
        std::vector<std::string> texts;
        for (const LineEndRow& row : rows) texts.push_back(row.*text);
        columns.push_back(make_cells(heading, texts));
    };
    const auto add = [&](const char* heading, const auto& take) {
        std::vector<double> values;
        for (const LineEndRow& row : rows) values.push_back(take(row));
        columns.push_back(make_cells(std::vector<std::string>{heading}, values));
    };
    add_texts("point", &LineEndRow::point);
    add_texts("quantity", &LineEndRow::quantity);
    add_texts("dimension", &LineEndRow::dimension);
    add("static", [](const LineEndRow& row) { return row.at_rest; });
    add("least", [](const LineEndRow& row) { return row.range.least; });
    add("time_of_least", [](const LineEndRow& row) { return row.range.time_of_least; });
    add("largest", [](const LineEndRow& row) { return row.range.largest; });
    add("time_of_largest", [](const LineEndRow& row) { return row.range.time_of_largest; });
    add("mean", [](const LineEndRow& row) { return row.range.mean(); });
    return columns;
}

std::string print_line_ends(const std::vector<LineEndRow>& rows) {
    constexpr const char* line = "{:<20} {:>12} {:>12} {:>10} {:>12} {:>10} {:>12}\n";
    std::string text;
    std::string point;
    for (const LineEndRow& row : rows) {
        if (row.point != point) {
            text += text.empty() ? "" : "\n";
            text +=
                fmt::format(fmt::runtime(line), row.point, "static", "least", "at", "largest", "at", "mean");
            point = row.point;
        }
        std::string words = "  " + row.quantity;
        std::ranges::replace(words, '_', ' ');
        if (row.dimension == "deg") words += ", deg";
        text += fmt::format(fmt::runtime(line),
                            words,
                            print_number(row.at_rest),
                            print_number(row.range.least),
                            print_number(row.range.time_of_least),
                            print_number(row.range.largest),
                            print_number(row.range.time_of_largest),
                            print_number(row.range.mean()));
    }
    return text;
}

}  // namespace gxrod
