#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "batch/cases/case_row.hpp"

// The table of a batch: index.csv, and while slices of it run parts/I-J.csv, one row a finished case.
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

// The parts of a folder, and what a part is of, if it is one.
std::vector<std::filesystem::path> list_parts(const std::filesystem::path& folder);
std::optional<CaseRange> range_of_part(const std::filesystem::path& part);

// The rows so far, by the number of the case; of a case that has several the last one, those of parts after
// those of the table. No two parts have the same case (gathering.hpp). A last line that was not completed is
// left out. Throws FileError.
std::vector<CaseRow> read_case_rows(const std::filesystem::path& folder, const BatchRecord& record);

// Rewrites index.csv with these rows.
void write_case_table(const std::filesystem::path& folder,
                      const BatchRecord& record,
                      const std::vector<CaseRow>& rows);

// Appends rows to a table, each whole or not at all, whenever the program is killed. Throws FileError.
class TableAppender {
  public:
    // Makes the table, with its header, if there is none; takes away a last line that was not completed.
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
