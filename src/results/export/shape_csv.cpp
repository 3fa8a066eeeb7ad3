#include "results/export/shape_csv.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "machine/file_error.hpp"
#include "model/model.hpp"
#include "results/tables/shape_table.hpp"

namespace gxrod {
namespace {

struct Column {
    std::string heading;
    std::vector<double> values;  // of each shape, one or six
    std::size_t width = 1;
};

std::string join_headings(const std::string& name, std::size_t width) {
    if (width == 1) return name;
    std::string text;
    for (std::size_t i = 0; i < width; ++i)
        text += fmt::format("{}{}_{}", i > 0 ? "," : "", name, component_names.at(i));
    return text;
}

// What has a number, or six, for each shape.
std::vector<Column> read_columns(const Hdf5Reader& file, const std::string& group, std::size_t shapes) {
    std::vector<Column> columns;
    for (const std::string& name : file.members(group)) {
        if (name == shape_words_name) continue;
        const std::string path = group + "/" + name;
        const std::vector<hsize_t> size = file.size(path);
        if (size.empty() || size.size() > 2 || size[0] != shapes || name == "total_mass") continue;
        const std::size_t width = size.size() == 2 ? size[1] : 1;
        columns.push_back({join_headings(name, width), file.numbers(path), width});
    }
    return columns;
}

std::string quote(const std::string& text) {
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + "\"";
}

}  // namespace

void write_shape_csv(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path) {
    const std::vector<std::string> words = file.texts(group + "/" + shape_words_name);
    const std::vector<Column> columns = read_columns(file, group, words.size());
    std::ofstream out(path, std::ios::binary);
    out << "number";
    for (const Column& column : columns) out << ',' << column.heading;
    out << ',' << shape_words_name << '\n';
    for (std::size_t row = 0; row < words.size(); ++row) {
        out << row + 1;
        for (const Column& column : columns) {
            for (std::size_t i = 0; i < column.width; ++i)
                out << fmt::format(",{}", column.values.at(row * column.width + i));
        }
        out << ',' << quote(words[row]) << '\n';
    }
    out.close();
    if (!out) throw FileError(path, "cannot be written", std::generic_category().message(errno));
}

void write_response_csv(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path) {
    std::vector<Column> columns;
    for (const char* name : {"omega", "frequency", "error"})
        columns.push_back({name, file.numbers(group + "/" + name), 1});
    const std::string histories = group + "/histories";
    for (const std::string& point : file.members(histories)) {
        for (const std::string& quantity : file.members(histories + "/" + point)) {
            const std::string name = point + "_" + quantity;
            std::string heading;
            for (const char letter : {'x', 'y', 'z'})
                heading += fmt::format(
                    "{}{}_{}_real,{}_{}_imaginary", heading.empty() ? "" : ",", name, letter, name, letter);
            columns.push_back({heading, file.numbers(histories + "/" + point + "/" + quantity), 6});
        }
    }
    std::ofstream out(path, std::ios::binary);
    for (std::size_t i = 0; i < columns.size(); ++i) out << (i == 0 ? "" : ",") << columns[i].heading;
    out << '\n';
    for (std::size_t row = 0; row < columns[0].values.size(); ++row) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            for (std::size_t k = 0; k < columns[i].width; ++k)
                out << fmt::format(
                    "{}{}", i == 0 ? "" : ",", columns[i].values.at(row * columns[i].width + k));
        }
        out << '\n';
    }
    out.close();
    if (!out) throw FileError(path, "cannot be written", std::generic_category().message(errno));
}

}  // namespace gxrod
