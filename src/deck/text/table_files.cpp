#include "deck/text/table_files.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "deck/text/text_file.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

std::string trim(const std::string& text) {
    constexpr const char* blanks = " \t";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Output of OpenFAST, which is no text.
std::string read_binary(const std::filesystem::path& path) {
    std::ifstream input(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>()};
    if (bytes.empty()) throw FileError(path, "cannot be read, or is empty");
    return bytes;
}

}  // namespace

std::string TableFiles::read(const std::string& file) const {
    if (kept_ == nullptr && file.ends_with(".outb")) return read_binary(folder_ / file);
    if (kept_ == nullptr) return read_text_file(folder_ / file, "a table", most_deck_bytes);
    const auto found = std::find_if(
        kept_->begin(), kept_->end(), [&](const MeshRecord& record) { return record.file == file; });
    if (found == kept_->end()) throw FileError(file, "is not kept in the results file");
    return found->bytes;
}

void keep_file(const std::string& file, const std::string& bytes, std::vector<MeshRecord>& records) {
    const auto same = [&](const MeshRecord& record) { return record.file == file; };
    if (std::none_of(records.begin(), records.end(), same)) records.push_back({file, bytes});
}

std::optional<double> read_finite(const std::string& field) {
    const std::string text = trim(field);
    if (text.empty() || text.find_first_of("xXpP") != std::string::npos) return std::nullopt;
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (*end != '\0' || !std::isfinite(value)) return std::nullopt;
    return value;
}

FileTable read_file_table(std::string_view bytes, const std::string& file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
    FileTable table{.header = {}, .rows = read_csv(bytes, file)};
    std::erase_if(table.rows, [](const CsvRow& row) { return trim(row.fields.front()).starts_with('#'); });
    if (table.rows.empty()) return table;
    table.header_line = table.rows.front().line;
    const std::vector<std::string>& first = table.rows.front().fields;
    if (std::all_of(first.begin(), first.end(), [](const auto& field) { return read_finite(field); })) {
        return table;
    }
    for (const std::string& field : first) table.header.push_back(trim(field));
    table.rows.erase(table.rows.begin());
    return table;
}

}  // namespace gxrod
