#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/text/fault_list.hpp"
#include "deck/text/table_files.hpp"
#include "model/model.hpp"

// Sections along a rod from a CSV file, a row for each station.
namespace gxrod {

struct SectionRow {
    double fraction;  // fraction of the rod's length
    Section section;  // with the name of the file; its mass is zero if the file has none
};

struct SectionFile {
    std::vector<SectionRow> rows;                  // at least two, from 0 to 1
    std::vector<std::pair<double, double>> twist;  // fractions and angles; empty if the file has none
};

using SectionFiles = std::map<int, SectionFile>;  // by index in Model::rods

// Reads a file. Throws FileError whose text begins with "file:line:column", the column counted in fields.
SectionFile read_section_file(std::string_view bytes, const std::string& file);

// Reads the files of the rods of a deck. If a file is wrong, adds a fault and no entry for the rod. Adds the
// files' bytes to `records`.
SectionFiles read_section_files(const CheckedTable& deck,
                                const TableFiles& files,
                                FaultList& faults,
                                std::vector<MeshRecord>& records);

}  // namespace gxrod
