#include "results/export/item_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "results/export/csv_columns.hpp"

namespace gxrod {

void write_item_csv(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path) {
    constexpr std::array texts{"kind", "branching", "words", "finding", "name", "cause"};
    std::vector<CsvCells> columns;
    for (const std::string& name : file.members(group)) {
        const bool is_text = std::find(texts.begin(), texts.end(), name) != texts.end();
        const std::string dataset = fmt::format("{}/{}", group, name);
        columns.push_back(is_text ? make_cells(name, file.texts(dataset))
                                  : make_cells(std::vector{name}, file.numbers(dataset)));
    }
    write_csv(path, columns);
}

}  // namespace gxrod
