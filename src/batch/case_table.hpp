#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "batch/case_row.hpp"

// The table of a batch: index.csv, and while slices of it run parts/I-J.csv, one row a finished case.
namespace gxrod {

struct CaseRange {
    long first = 1;
    long last = 1;

    bool contains(long number) const { return first <= number && number <= last; }
    bool operator==(const CaseRange&) const = default;
};

std::filesystem::path table_path(const std::filesystem::path& folder);
std::filesystem::path part_path(const std::filesystem::path& folder, const CaseRange& range);

// The parts of a folder, the one written last at the end, and what a part is of.
std::vector<std::filesystem::path> list_parts(const std::filesystem::path& folder);
CaseRange range_of_part(const std::filesystem::path& part);

// The rows so far, by the number of the case; of a case that has several the last one, those of parts after
// those of the table. A last line that was not completed is left out. Throws FileError.
std::vector<CaseRow> read_case_rows(const std::filesystem::path& folder, const BatchRecord& record);

// Makes a folder, and those above it. Throws FileError.
void make_folder(const std::filesystem::path& folder);

// Writes a file beside and moves it there, so that it is whole at every moment. Throws FileError.
void replace_file(const std::filesystem::path& path, const std::string& text);

// Writes index.csv anew with these rows.
void write_case_table(const std::filesystem::path& folder,
                      const BatchRecord& record,
                      const std::vector<CaseRow>& rows);

// Appends rows to a table, each whole or not at all, wherever the program is killed. Throws FileError.
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
