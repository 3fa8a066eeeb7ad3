#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/text/csv_reading.hpp"
#include "model/deck_record.hpp"

// Files with columns of numbers that a deck names.
namespace gxrod {

// The source of these files: the deck's folder, or, for a deck from a results file, the bytes that are kept
// with it.
class TableFiles {
  public:
    explicit TableFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
    // The records must outlive this.
    explicit TableFiles(const std::vector<MeshRecord>& records) : kept_(&records) {}

    // Reads the bytes of a file that the deck names. Throws FileError.
    std::string read(const std::string& file) const;

  private:
    std::filesystem::path folder_;
    const std::vector<MeshRecord>* kept_ = nullptr;
};

// Adds a file to the records, unless they have it.
void keep_file(const std::string& file, const std::string& bytes, std::vector<MeshRecord>& records);

// The table in a file.
struct FileTable {
    std::vector<std::string> header;  // without blanks around; empty if the first row holds numbers
    int header_line = 1;              // line of the header or the first row
    std::vector<CsvRow> rows;
};

// Reads a table. The first row is a header unless it holds only numbers. Rows that begin with # are comments.
// Errors name `file`. Throws FileError.
FileTable read_file_table(std::string_view bytes, const std::string& file);

// Reads a field as a finite number, with or without blanks around it; nullopt if it is not one.
std::optional<double> read_finite(const std::string& field);

}  // namespace gxrod
