#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "batch/cases/case_row.hpp"

// The table of a batch, one row per finished case: index.csv, and parts/I-J.csv while slices run.
namespace gxrod {

struct CaseRange {
    long first = 1;
    long last = 1;

    long count() const { return last - first + 1; }
    bool contains(long number) const { return first <= number && number <= last; }
    bool operator==(const CaseRange&) const = default;
};

std::filesystem::path table_path(const std::filesystem::path& folder);
std::filesystem::path part_path(const std::filesystem::path& folder, const CaseRange& range);

// List the parts of a folder, and return the cases of a part if the file is one.
std::vector<std::filesystem::path> list_parts(const std::filesystem::path& folder);
std::optional<CaseRange> range_of_part(const std::filesystem::path& part);

// Reads the rows so far, by the number of the case. If a case has several, the last one counts; rows of parts
// come after rows of the table. No two parts have the same case (gathering.hpp). An incomplete last line is
// left out. Throws FileError.
std::vector<CaseRow> read_case_rows(const std::filesystem::path& folder, const BatchRecord& record);

// Rewrites index.csv with these rows.
void write_case_table(const std::filesystem::path& folder,
                      const BatchRecord& record,
                      const std::vector<CaseRow>& rows);

// Appends rows to a table, each whole or not at all, even if the program is killed. Throws FileError.
class TableAppender {
  public:
    // Makes the table, with its header, if there is none; removes an incomplete last line.
    TableAppender(std::filesystem::path path, const BatchRecord& record);
    ~TableAppender();
    TableAppender(const TableAppender&) = delete;
    TableAppender& operator=(const TableAppender&) = delete;

    void append(const CaseRow& row);

  private:
    void write(const std::string& line);

    std::filesystem::path path_;
    int descriptor_;
};

}  // namespace gxrod
