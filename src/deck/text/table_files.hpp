#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/text/csv_reading.hpp"
#include "model/deck_record.hpp"

// The files of numbers, in columns, that a deck names.
namespace gxrod {

// Where they are: next to the deck, or, for a deck from a results file, the bytes that are kept with it.
class TableFiles {
  public:
    explicit TableFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
    // The records must outlive this.
    explicit TableFiles(const std::vector<MeshRecord>& records) : kept_(&records) {}

    // The bytes of a file as the deck names it. Throws FileError.
    std::string read(const std::string& file) const;

  private:
    std::filesystem::path folder_;
    const std::vector<MeshRecord>* kept_ = nullptr;
};

// Adds a file to the records, unless they have it.
void keep_file(const std::string& file, const std::string& bytes, std::vector<MeshRecord>& records);

// A table as its file has it.
struct FileTable {
    std::vector<std::string> header;  // without blanks around; empty if the first row is one of numbers
    int header_line = 1;              // where it is, or the first row
    std::vector<CsvRow> rows;
};

// The first row is a header if not all of it are numbers. Rows that begin with # are comments. `file` is what
// errors name. Throws FileError.
FileTable read_file_table(std::string_view bytes, const std::string& file);

// The finite number that a field is, blanks around it or not; nullopt if it is not one.
std::optional<double> read_finite(const std::string& field);

}  // namespace gxrod
