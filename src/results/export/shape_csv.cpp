#include "results/export/shape_csv.hpp"

#include <fmt/format.h>

#include <numeric>

#include "model/model.hpp"
#include "results/export/csv_columns.hpp"
#include "results/tables/shape_table.hpp"

namespace gxrod {
namespace {

// What has a number, or six, for each shape.
std::vector<CsvCells> read_columns(const Hdf5Reader& file, const std::string& group, std::size_t shapes) {
    std::vector<CsvCells> columns;
    for (const std::string& name : file.members(group)) {
        if (name == shape_words_name) continue;
        const std::string path = fmt::format("{}/{}", group, name);
        const std::vector<hsize_t> size = file.size(path);
        if (size.empty() || size.size() > 2 || size[0] != shapes || name == "total_mass") continue;
        std::vector<std::string> headings{name};
        if (size.size() == 2) {
            headings.clear();
            for (const std::string_view component : component_names)
                headings.push_back(fmt::format("{}_{}", name, component));
        }
        columns.push_back(make_cells(std::move(headings), file.numbers(path)));
    }
    return columns;
}

// A column for each mode.
CsvCells read_modes(const Hdf5Reader& file,
                    const std::string& group,
                    const std::string& name,
                    std::size_t modes) {
    std::vector<std::string> headings;
    for (std::size_t i = 0; i < modes; ++i) headings.push_back(fmt::format("{}_{}", name, i + 1));
    return make_cells(std::move(headings), file.numbers(group + "/" + name));
}

}  // namespace

void write_shape_csv(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path) {
    const std::vector<std::string> words = file.texts(group + "/" + shape_words_name);
    std::vector<double> numbers(words.size());
    std::iota(numbers.begin(), numbers.end(), 1.0);
    std::vector<CsvCells> columns{make_cells(std::vector<std::string>{"number"}, numbers)};
    for (CsvCells& column : read_columns(file, group, words.size())) columns.push_back(std::move(column));
    columns.push_back(make_cells(shape_words_name, words));
    write_csv(path, columns);
}

void write_response_csv(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path) {
    std::vector<CsvCells> columns;
    for (const char* name : {"omega", "frequency", "error"})
        columns.push_back(make_cells(std::vector<std::string>{name}, file.numbers(group + "/" + name)));
    const std::string histories = group + "/histories";
    for (const std::string& point : file.members(histories)) {
        for (const std::string& quantity : file.members(fmt::format("{}/{}", histories, point))) {
            const std::string name = fmt::format("{}_{}", point, quantity);
            std::vector<std::string> headings;
            for (const char letter : {'x', 'y', 'z'}) {
                headings.push_back(fmt::format("{}_{}_real", name, letter));
                headings.push_back(fmt::format("{}_{}_imaginary", name, letter));
            }
            columns.push_back(make_cells(std::move(headings),
                                         file.numbers(fmt::format("{}/{}/{}", histories, point, quantity))));
        }
    }
    write_csv(path, columns);
}

void write_sweep_csv(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path) {
    std::vector<CsvCells> columns;
    for (const char* name : {sweep_values_name, "speed", "largest_growth"})
        columns.push_back(make_cells(std::vector<std::string>{name}, file.numbers(group + "/" + name)));
    const std::size_t modes = file.size(group + "/" + shape_words_name).at(0);
    for (const char* name : {"omega", "growth", "corruption"})
        columns.push_back(read_modes(file, group, name, modes));
    write_csv(path, columns);
}

}  // namespace gxrod
