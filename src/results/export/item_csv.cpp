#include "results/export/item_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "machine/file_error.hpp"

namespace gxrod {
namespace {

struct ItemColumn {
    std::string name;
    std::vector<std::string> cells;
};

std::string quote(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + "\"";
}

ItemColumn read_items(const Hdf5Reader& file,
                      const std::string& path,
                      const std::string& name,
                      bool is_text) {
    ItemColumn column{name, {}};
    if (is_text) {
        for (const std::string& text : file.texts(path)) column.cells.push_back(quote(text));
    } else {
        for (const double number : file.numbers(path)) column.cells.push_back(fmt::format("{}", number));
    }
    return column;
}

}  // namespace

void write_item_csv(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path) {
    constexpr std::array texts{"kind", "branching", "words", "finding", "name", "cause"};
    std::vector<ItemColumn> columns;
    for (const std::string& name : file.members(group)) {
        const bool is_text = std::find(texts.begin(), texts.end(), name) != texts.end();
        columns.push_back(read_items(file, group + "/" + name, name, is_text));
    }
    std::ofstream out(path, std::ios::binary);
    for (std::size_t i = 0; i < columns.size(); ++i) out << (i == 0 ? "" : ",") << columns[i].name;
    out << '\n';
    const std::size_t rows = columns.empty() ? 0 : columns[0].cells.size();
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < columns.size(); ++i)
            out << (i == 0 ? "" : ",") << columns[i].cells.at(row);
        out << '\n';
    }
    out.close();
    if (!out) throw FileError(path, "cannot be written", std::generic_category().message(errno));
}

}  // namespace gxrod
