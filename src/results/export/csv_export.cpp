#include "results/export/csv_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "machine/file_error.hpp"
#include "results/component_labels.hpp"
#include "results/export/item_csv.hpp"
#include "results/export/shape_csv.hpp"
#include "results/file/results_access.hpp"
#include "results/tables/sample_table.hpp"
#include "results/tables/stage_table.hpp"

namespace gxrod {

namespace {

constexpr hsize_t most_rows_at_once = 4096;

// One dataset of a group, which makes one or more columns.
struct CsvColumn {
    std::string path;
    std::string name;
    hsize_t width = 1;

    std::string heading() const {
        if (width == 1) return name;
        std::string text;
        for (const std::string& label : list_component_labels(name, width))
            text += fmt::format("{}{}_{}", text.empty() ? "" : ",", name, label);
        return text;
    }
};

const std::string sampled_group = std::string("/") + samples_group_name;
const std::string sampled_time = sampled_group + "/time";

bool is_sampled(const std::string& group) { return group.starts_with(sampled_group + "/"); }

void add_members(const Hdf5Reader& file, const std::string& group, std::vector<CsvColumn>& columns) {
    for (const std::string& name : file.members(group)) {
        if (!is_history_name(name)) continue;
        const std::string path = fmt::format("{}/{}", group, name);
        columns.push_back({path, name, file.width(path)});
    }
}

// The datasets of a group, time first.
std::vector<CsvColumn> find_columns(const Hdf5Reader& file, const std::string& group) {
    if (is_sampled(group)) {
        std::vector<CsvColumn> columns{{sampled_time, "time"}};
        add_members(file, group, columns);
        return columns;
    }
    std::vector<CsvColumn> columns{{"/histories/time", "time"}};
    const bool has_paths = file.has("/histories/load_factor");
    const bool has_stages = file.has("/histories/stage");
    if (has_paths && !has_stages) {
        columns[0].name = "arc_length";
    } else if (file.text_attribute("/histories/time", "dimension") == "1") {
        columns[0].name = "load_factor";
    }
    for (const char* name : {"stage", "load_factor", "limit_load_factor", "branch"}) {
        const std::string path = std::string("/histories/") + name;
        if (file.has(path)) columns.push_back({path, name});
    }
    add_members(file, group, columns);
    return columns;
}

void append_rows(const Hdf5Reader& file,
                 const std::vector<CsvColumn>& columns,
                 hsize_t first,
                 hsize_t count,
                 fmt::memory_buffer& text) {
    std::vector<std::vector<double>> values;
    for (const CsvColumn& column : columns)
        values.push_back(file.rows(column.path, first, count, column.width));
    for (hsize_t row = 0; row < count; ++row) {
        const char* separator = "";
        for (std::size_t i = 0; i < columns.size(); ++i) {
            for (hsize_t j = 0; j < columns[i].width; ++j) {
                fmt::format_to(
                    std::back_inserter(text), "{}{}", separator, values[i][row * columns[i].width + j]);
                separator = ",";
            }
        }
        text.push_back('\n');
    }
}

void write_table(const Hdf5Reader& file, const std::string& group, const std::filesystem::path& path) {
    std::ofstream out(path, std::ios::binary);
    const std::vector<CsvColumn> columns = find_columns(file, group);
    // The times are written last, so their number is that of complete rows.
    const hsize_t rows = file.size(columns[0].path).at(0);
    std::string headings;
    for (const CsvColumn& column : columns) headings += (headings.empty() ? "" : ",") + column.heading();
    out << headings << '\n';
    for (hsize_t first = 0; first < rows && out; first += most_rows_at_once) {
        fmt::memory_buffer text;
        append_rows(file, columns, first, std::min(most_rows_at_once, rows - first), text);
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
    }
    out.close();
    if (!out) throw FileError(path, "cannot be written", std::generic_category().message(errno));
}

struct CsvTable {
    std::string group;
    std::filesystem::path path;
    void (*write)(const Hdf5Reader&, const std::string&, const std::filesystem::path&) = write_table;
};

std::vector<CsvTable> list_tables(const Hdf5Reader& file, const std::filesystem::path& folder) {
    std::vector<CsvTable> tables{{"/ledger", folder / "ledger.csv"}, {"/solver", folder / "solver.csv"}};
    for (const std::string& name : file.members("/histories")) {
        if (is_history_name(name))
            tables.push_back({"/histories/" + name, folder / ("history_" + name + ".csv")});
    }
    if (file.has(sampled_group)) {
        for (const std::string& name : file.members(sampled_group)) {
            if (is_history_name(name))
                tables.push_back(
                    {fmt::format("{}/{}", sampled_group, name), folder / ("sampled_" + name + ".csv")});
        }
    }
    if (!file.has("/stages")) return tables;
    for (const std::string& name : file.members("/stages")) {
        const std::string group = "/stages/" + name;
        const bool is_sweep = file.has(group + "/" + sweep_values_name);
        if (file.has(group + "/" + shape_words_name))
            tables.push_back(
                {group, folder / ("stage_" + name + ".csv"), is_sweep ? write_sweep_csv : write_shape_csv});
        if (file.has(group + "/histories"))
            tables.push_back({group, folder / ("stage_" + name + ".csv"), write_response_csv});
        for (const char* table : {critical_points_name, branches_name, onsets_name}) {
            const std::string items = fmt::format("{}/{}", group, table);
            if (file.has(items))
                tables.push_back(
                    {items, folder / fmt::format("stage_{}_{}.csv", name, table), write_item_csv});
        }
    }
    return tables;
}

}  // namespace

std::vector<std::filesystem::path> export_csv(const std::filesystem::path& results,
                                              const std::filesystem::path& folder,
                                              Existing existing) {
    std::vector<std::filesystem::path> written;
    read_results(results, [&](const Hdf5Reader& file) {
        const std::vector<CsvTable> tables = list_tables(file, folder);
        written.clear();
        for (const CsvTable& table : tables) written.push_back(table.path);
        prepare_export(folder, written, existing);
        existing = Existing::replace;  // a second attempt finds our own files
        for (const CsvTable& table : tables) table.write(file, table.group, table.path);
    });
    return written;
}

}  // namespace gxrod
