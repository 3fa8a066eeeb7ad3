#include "deck/expressions/function_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "deck/reading/reading_context.hpp"
#include "deck/schema/suggestion.hpp"
#include "machine/file_error.hpp"
#include "machine/printable.hpp"

namespace gxrod {
namespace {

class FunctionFile {
  public:
    FunctionFile(DeckNode& function, std::string path, FaultList& faults)
        : function_(function), path_(std::move(path)), faults_(faults) {}

    // The rows as the deck would have them; nullopt with a fault.
    std::optional<DeckNode> read(const std::string& bytes, const std::string& file) {
        try {
            const FileTable table = read_file_table(bytes, file);
            const auto time = find_column(table, 0);
            const auto value = find_column(table, 1);
            if (!time || !value) return std::nullopt;
            return read_rows(table, *time, *value);
        } catch (const FileError& error) {
            add_fault("file", error.what());
            return std::nullopt;
        }
    }

    void add_fault(const char* key, std::string message) {
        faults_.add(function_.find(key)->node.place, path_ + "." + key, std::move(message));
        is_wrong_ = true;
    }

  private:
    std::size_t width_of(const FileTable& table) const {
        if (!table.header.empty()) return table.header.size();
        return table.rows.empty() ? 0 : table.rows.front().fields.size();
    }

    // Of the time, 0, or the value, 1.
    std::optional<std::size_t> find_column(const FileTable& table, std::size_t which) {
        const std::size_t width = width_of(table);
        const DeckEntry* given = function_.find("columns");
        if (given == nullptr) {
            if (which < width) return which;
            if (which == 1 && !is_wrong_) {
                add_fault("file", "expected two columns, parted by commas, found one");
            } else if (!is_wrong_) {
                add_fault("file", "expected rows of numbers, found none");
            }
            return std::nullopt;
        }
        const DeckNode::Array* columns = given->node.array();
        if (columns == nullptr || columns->size() != 2) {
            if (!is_wrong_) add_fault("columns", expected_columns(given->node));
            return std::nullopt;
        }
        const DeckNode& column = (*columns)[which];
        if (const auto* number = std::get_if<std::int64_t>(&column.value)) {
            if (*number >= 1 && static_cast<std::size_t>(*number) <= width)
                return static_cast<std::size_t>(*number) - 1;
            add_fault("columns", fmt::format("there is no column {}; the file has {}", *number, width));
            return std::nullopt;
        }
        if (column.text() == nullptr) {
            add_fault("columns", expected_columns(column));
            return std::nullopt;
        }
        return find_named(table, *column.text());
    }

    static std::string expected_columns(const DeckNode& found) {
        return "expected 2 names or numbers of columns, such as [\"t\", \"x\"] or [1, 3], found " +
               describe_found(found);
    }

    std::optional<std::size_t> find_named(const FileTable& table, const std::string& name) {
        const auto found = std::find(table.header.begin(), table.header.end(), name);
        if (found != table.header.end()) return static_cast<std::size_t>(found - table.header.begin());
        if (table.header.empty()) {
            add_fault(
                "columns",
                fmt::format("the file has no header with \"{}\"; count its columns instead, as in [1, 2]",
                            shorten(name)));
        } else {
            const std::string hint = did_you_mean(name, table.header);
            add_fault("columns",
                      fmt::format("there is no column \"{}\"{}{} the file has {}",
                                  shorten(name),
                                  hint,
                                  hint.ends_with('?') ? "" : ";",
                                  quoted_list(table.header)));
        }
        return std::nullopt;
    }

    std::optional<double> read_field(const CsvRow& row, std::size_t column) {
        if (column >= row.fields.size()) {
            add_fault("file",
                      fmt::format("line {}: expected {} columns or more, found {}",
                                  row.line,
                                  column + 1,
                                  row.fields.size()));
            return std::nullopt;
        }
        const auto value = read_finite(row.fields[column]);
        if (!value) {
            add_fault("file",
                      fmt::format("line {}: expected a finite number, found \"{}\"",
                                  row.line,
                                  shorten(row.fields[column])));
        }
        return value;
    }

    std::optional<DeckNode> read_rows(const FileTable& table, std::size_t time, std::size_t value) {
        const Place place = function_.find("file")->node.place;
        DeckNode::Array rows;
        rows.reserve(table.rows.size());
        double before = 0.0;
        for (const CsvRow& row : table.rows) {
            const auto at = read_field(row, time);
            if (!at) return std::nullopt;
            const auto found = read_field(row, value);
            if (!found) return std::nullopt;
            if (!rows.empty() && *at <= before) {
                add_fault("file",
                          fmt::format("line {}: expected a time after {}, that of the row before, found {}",
                                      row.line,
                                      before,
                                      *at));
                return std::nullopt;
            }
            before = *at;
            rows.push_back({DeckNode::Array{{*at, place}, {*found, place}}, place});
        }
        if (rows.empty()) {
            add_fault("file", "expected rows of numbers, found none");
            return std::nullopt;
        }
        return DeckNode{std::move(rows), place};
    }

    DeckNode& function_;
    std::string path_;
    FaultList& faults_;
    bool is_wrong_ = false;
};

// The name of its file, if that is where a function's rows are to come from.
const std::string* find_file(const DeckNode& function) {
    if (function.table() == nullptr) return nullptr;
    const DeckEntry* file = function.find("file");
    const bool is_alone = function.find("table") == nullptr && function.find("expression") == nullptr;
    return file == nullptr || !is_alone ? nullptr : file->node.text();
}

}  // namespace

bool has_function_files(const DeckNode& deck) {
    const DeckEntry* functions = deck.find("function");
    if (functions == nullptr || functions->node.table() == nullptr) return false;
    const DeckNode::Table& entries = *functions->node.table();
    return std::any_of(entries.begin(), entries.end(), [](const DeckEntry& entry) {
        return find_file(entry.node) != nullptr;
    });
}

void fill_function_tables(DeckNode& deck,
                          const TableFiles& files,
                          std::vector<MeshRecord>& records,
                          FaultList& faults) {
    if (!has_function_files(deck)) return;
    for (DeckEntry& entry : *deck.find("function")->node.table()) {
        const std::string* file = find_file(entry.node);
        if (file == nullptr) continue;
        FunctionFile function(entry.node, "function." + entry.key, faults);
        std::string bytes;
        try {
            bytes = files.read(*file);
        } catch (const FileError& error) {
            function.add_fault("file", error.what());
            continue;
        }
        std::optional<DeckNode> rows = function.read(bytes, *file);
        if (!rows) continue;
        keep_file(*file, bytes, records);
        const Place place = entry.node.find("file")->place;
        std::erase_if(*entry.node.table(),
                      [](const DeckEntry& key) { return key.key == "file" || key.key == "columns"; });
        entry.node.table()->push_back({"table", place, std::move(*rows)});
    }
}

}  // namespace gxrod
