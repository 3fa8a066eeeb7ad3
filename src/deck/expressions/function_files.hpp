#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "deck/reading/deck_tree.hpp"
#include "model/deck_record.hpp"

namespace gxrod {

// Where the tables are that [function.NAME] takes from files: next to the deck, or, for a deck from a results
// file, the bytes that are kept with it.
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

// Puts the rows of each function's `file` and `columns` in place of these keys, as `table`; the deck's other
// keys stay. What is wrong with a file or its columns becomes a fault, and its keys stay too. The files are
// added to the records.
void fill_function_tables(DeckNode& deck,
                          const TableFiles& files,
                          std::vector<MeshRecord>& records,
                          FaultList& faults);

// Whether any function of the deck names a file.
bool has_function_files(const DeckNode& deck);

}  // namespace gxrod
