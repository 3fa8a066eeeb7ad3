#include "results/export/envelope_export.hpp"

#include <fmt/format.h>

#include "machine/file_error.hpp"
#include "results/export/csv_columns.hpp"
#include "results/export/rod_line.hpp"
#include "results/file/results_access.hpp"

namespace gxrod {
namespace {

const std::string envelope_path = "/envelopes/";

// Names by the numbers of a column; "" for a number that has none, and the number itself if nothing has a
// name.
std::vector<std::string> name_numbers(const std::vector<double>& numbers,
                                      const std::vector<std::string>& names) {
    std::vector<std::string> texts;
    for (const double number : numbers) {
        const bool has_name = number >= 0.0 && number < static_cast<double>(names.size());
        texts.push_back(has_name        ? names[static_cast<std::size_t>(number)]
                        : names.empty() ? fmt::format("{}", number)
                                        : "");
    }
    return texts;
}

void add_stress_measure(const Hdf5Reader& file,
                        const std::string& measure,
                        hsize_t rows,
                        std::vector<CsvCells>& columns) {
    const auto add = [&](const char* dataset, hsize_t width, const std::vector<const char*>& endings) {
        std::vector<std::string> headings;
        for (const char* ending : endings) headings.push_back(measure + ending);
        columns.push_back(make_cells(
            headings, file.rows(fmt::format("{}{}/{}", envelope_path, measure, dataset), 0, rows, width)));
    };
    add("value", 1, {""});
    add("time", 1, {"_time"});
    add("point", 2, {"_y", "_z"});
    add("layer", 1, {"_layer"});
    add("resultants", 6, {"_N", "_Vy", "_Vz", "_T", "_My", "_Mz"});
}

std::vector<CsvCells> read_envelope_columns(const Hdf5Reader& file) {
    const std::vector<double> rods = file.numbers(envelope_path + "rod");
    const auto numbers = [&](const char* name) { return file.rows(envelope_path + name, 0, rods.size(), 1); };
    const std::vector<std::string> sections = file.texts("/sections/name");
    std::vector<CsvCells> columns;
    columns.push_back(make_cells("rod", name_numbers(rods, read_rod_names(file))));
    columns.push_back(make_cells(std::vector<std::string>{"element"}, numbers("element")));
    columns.push_back(make_cells(std::vector<std::string>{"arc_length"}, numbers("arc_length")));
    columns.push_back(make_cells("section", name_numbers(numbers("section"), sections)));
    for (const char* measure : {"von_mises", "exposure"}) {
        if (file.has(envelope_path + measure)) add_stress_measure(file, measure, rods.size(), columns);
    }
    return columns;
}

}  // namespace

std::filesystem::path export_envelopes(const std::filesystem::path& results,
                                       const std::filesystem::path& folder,
                                       Existing existing) {
    std::vector<CsvCells> columns;
    read_results(results, [&](const Hdf5Reader& file) {
        if (!file.has(envelope_path + "rod"))
            throw FileError(results, "has no stresses", "run it with stresses = \"von-mises\" in [output]");
        columns = read_envelope_columns(file);
    });
    std::filesystem::path path = folder / "envelopes.csv";
    prepare_export(folder, {path}, existing);
    write_csv(path, columns);
    return path;
}

}  // namespace gxrod
