#include "batch/cases/case_table.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <map>
#include <system_error>

#include "batch/batch_folder.hpp"
#include "deck/text/text_file.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const fs::path& path) {
    throw FileError(path, "cannot be written", std::generic_category().message(errno));
}

// The whole lines of a table; a row is one line.
std::string read_complete_lines(const fs::path& path) {
    std::string text = read_text_file(path);
    text.resize(text.rfind('\n') + 1);
    return text;
}

void check_header(const CsvRow& header, const BatchRecord& record, const fs::path& path) {
    std::string line;
    for (const std::string& field : header.fields) line += (line.empty() ? "" : ",") + write_csv_field(field);
    if (line == write_case_header(record)) return;
    throw FileError(path, "is the table of another batch: its columns differ from those of batch.json");
}

void add_rows(const fs::path& path, const BatchRecord& record, std::map<long, CaseRow>& rows) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) return;
    const std::vector<CsvRow> lines = read_csv(read_complete_lines(path), path);
    if (lines.empty()) return;
    check_header(lines[0], record, path);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        CaseRow row = read_case_row(lines[i], record, path);
        rows.insert_or_assign(row.number, std::move(row));
    }
}

}  // namespace

fs::path table_path(const fs::path& folder) { return folder / "index.csv"; }

fs::path part_path(const fs::path& folder, const CaseRange& range) {
    return folder / "parts" / fmt::format("{}-{}.csv", range.first, range.last);
}

std::vector<fs::path> list_parts(const fs::path& folder) {
    std::vector<fs::path> parts;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "parts", ignored)) {
        if (entry.path().extension() == ".csv" && range_of_part(entry.path())) parts.push_back(entry.path());
    }
    return parts;
}

std::optional<CaseRange> range_of_part(const fs::path& part) {
    CaseRange range;
    const std::string name = part.stem().string();
    const char* end = name.data() + name.size();
    const auto first = std::from_chars(name.data(), end, range.first);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != '-') return std::nullopt;
    const auto last = std::from_chars(first.ptr + 1, end, range.last);
    if (last.ec != std::errc() || last.ptr != end || range.first < 1 || range.last < range.first)
        return std::nullopt;
    return range;
}

std::vector<CaseRow> read_case_rows(const fs::path& folder, const BatchRecord& record) {
    std::map<long, CaseRow> rows;
    add_rows(table_path(folder), record, rows);
    for (const fs::path& part : list_parts(folder)) add_rows(part, record, rows);
    std::vector<CaseRow> sorted;
    for (auto& [number, row] : rows) sorted.push_back(std::move(row));
    return sorted;
}

void write_case_table(const fs::path& folder, const BatchRecord& record, const std::vector<CaseRow>& rows) {
    std::string text = write_case_header(record) + "\n";
    for (const CaseRow& row : rows) text += write_case_row(row) + "\n";
    replace_file(table_path(folder), text);
}

TableAppender::TableAppender(fs::path path, const BatchRecord& record) : path_(std::move(path)) {
    std::error_code ignored;
    const bool exists = fs::exists(path_, ignored);
    const std::size_t complete = exists ? read_complete_lines(path_).size() : 0;
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail_to_write(path_);
    try {
        if (::ftruncate(descriptor_, static_cast<off_t>(complete)) != 0) fail_to_write(path_);
        if (complete == 0) write(write_case_header(record) + "\n");
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
}

TableAppender::~TableAppender() { ::close(descriptor_); }

void TableAppender::append(const CaseRow& row) { write(write_case_row(row) + "\n"); }

void TableAppender::write(const std::string& line) {
    const off_t before = ::lseek(descriptor_, 0, SEEK_END);
    const ssize_t written = ::write(descriptor_, line.data(), line.size());
    if (written == static_cast<ssize_t>(line.size())) return;
    const int code = written < 0 ? errno : ENOSPC;
    // Half a row would spoil the next one.
    if (written > 0 && ::ftruncate(descriptor_, before) != 0) errno = code;
    errno = code;
    fail_to_write(path_);
}

}  // namespace gxrod
