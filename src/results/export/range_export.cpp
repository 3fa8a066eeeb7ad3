#include "results/export/range_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machine/file_error.hpp"
#include "results/export/csv_columns.hpp"
#include "results/export/rod_line.hpp"
#include "results/file/results_access.hpp"

namespace gxrod {
namespace {

// A number of each element, made of a row of a dataset.
struct Measure {
    const char* name;
    const char* dataset;
    hsize_t width;
    double (*value)(const double* row);
};

double take_axial(const double* row) { return row[0]; }
double take_across(const double* row) { return std::hypot(row[1], row[2]); }

constexpr Measure measures[]{{"effective_tension", "force", 3, take_axial},
                             {"wall_tension", "wall_tension", 1, take_axial},
                             {"shear_force", "force", 3, take_across},
                             {"bending_moment", "moment", 3, take_across},
                             {"bending_curvature", "curvature", 3, take_across},
                             {"von_mises", "von_mises", 1, take_axial},
                             {"exposure", "exposure", 1, take_axial}};

struct RangeWindow {
    std::vector<double> times;  // of all frames
    std::vector<std::size_t> frames;
    hsize_t cells = 0;  // of a frame
};

std::vector<RangeOfNumbers> find_rod_ranges(const Hdf5Reader& file,
                                            const Measure& measure,
                                            const RodLine& line,
                                            const RangeWindow& window) {
    const std::string path = fmt::format("/VTKHDF/CellData/{}", measure.dataset);
    const std::size_t first = line.elements.front().cell;
    std::vector<RangeOfNumbers> ranges(line.elements.size());
    for (const std::size_t frame : window.frames) {
        const std::vector<double> rows =
            file.rows(path, frame * window.cells + first, ranges.size(), measure.width);
        for (std::size_t e = 0; e < ranges.size(); ++e)
            ranges[e].add(window.times[frame], measure.value(&rows[e * measure.width]));
    }
    return ranges;
}

std::vector<CsvCells> make_range_columns(const Hdf5Reader& file,
                                         const RodLine& line,
                                         const RangeWindow& window) {
    std::vector<double> middles, numbers;
    for (std::size_t e = 0; e < line.elements.size(); ++e) {
        middles.push_back(line.elements[e].middle);
        numbers.push_back(static_cast<double>(e));
    }
    std::vector<CsvCells> columns;
    columns.push_back(make_cells(std::vector<std::string>{"arc_length"}, middles));
    columns.push_back(make_cells(std::vector<std::string>{"element"}, numbers));
    for (const Measure& measure : measures) {
        if (!file.has(fmt::format("/VTKHDF/CellData/{}", measure.dataset))) continue;
        const std::vector<RangeOfNumbers> ranges = find_rod_ranges(file, measure, line, window);
        const auto add = [&](const char* ending, const auto& take) {
            std::vector<double> values;
            for (const RangeOfNumbers& range : ranges) values.push_back(take(range));
            columns.push_back(
                make_cells(std::vector<std::string>{std::string(measure.name) + ending}, values));
        };
        add("_least", [](const RangeOfNumbers& range) { return range.least; });
        add("_time_of_least", [](const RangeOfNumbers& range) { return range.time_of_least; });
        add("_largest", [](const RangeOfNumbers& range) { return range.largest; });
        add("_time_of_largest", [](const RangeOfNumbers& range) { return range.time_of_largest; });
        add("_mean", [](const RangeOfNumbers& range) { return range.mean(); });
    }
    return columns;
}

RangeWindow find_frames(const Hdf5Reader& file,
                        const std::filesystem::path& results,
                        const WindowRequest& request) {
    RangeWindow window;
    window.times = file.numbers("/VTKHDF/Steps/Values");
    window.cells = static_cast<hsize_t>(file.count("/VTKHDF/NumberOfCells"));
    const TimeWindow asked = find_window(file, results, request);
    window.frames = list_rows(window.times, asked);
    if (window.frames.empty())
        throw FileError(results,
                        fmt::format("has no frame from {:.10g} to {:.10g}", asked.first, asked.last));
    return window;
}

}  // namespace

std::vector<std::filesystem::path> export_ranges(const std::filesystem::path& results,
                                                 const std::filesystem::path& folder,
                                                 const std::string& rod,
                                                 const WindowRequest& request,
                                                 Existing existing) {
    std::vector<std::filesystem::path> paths;
    std::vector<std::vector<CsvCells>> tables;
    read_results(results, [&](const Hdf5Reader& file) {
        paths.clear();
        tables.clear();
        const std::vector<std::string> names = read_rod_names(file);
        if (names.empty()) throw FileError(results, "has no rods");
        if (!rod.empty() && std::ranges::find(names, rod) == names.end())
            throw FileError(results, "has no rod " + rod, fmt::format("it has {}", fmt::join(names, ", ")));
        const RangeWindow window = find_frames(file, results, request);
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (!rod.empty() && names[i] != rod) continue;
            paths.push_back(folder / fmt::format("range_{}.csv", names[i]));
            tables.push_back(make_range_columns(file, read_rod_line(file, i), window));
        }
    });
    prepare_export(folder, paths, existing);
    for (std::size_t i = 0; i < paths.size(); ++i) write_csv(paths[i], tables[i]);
    return paths;
}

}  // namespace gxrod
