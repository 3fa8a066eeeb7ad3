#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/surroundings/rao_file.hpp"
#include "deck/text/fault_list.hpp"
#include "deck/text/table_files.hpp"
#include "environment/sea.hpp"
#include "model/surroundings.hpp"

// Files of waves and of the ground that a deck names.
namespace gxrod {

struct SurroundingsFiles {
    std::map<std::size_t, ElevationRecord> waves{};  // by index in [[wave]]
    std::optional<GroundGrid> ground{};
    std::map<std::string, std::vector<RaoRow>> vessels{};  // by name
};

// Read the elevations of a record with their times, and a grid of the ground. Throw FileError whose text
// begins with "file:line".
ElevationRecord read_elevations(std::string_view bytes, const std::string& file);
GroundGrid read_ground_grid(std::string_view bytes, const std::string& file);

// Reads the files of a deck. If a file is wrong, adds a fault. Adds the files' bytes to `records`.
SurroundingsFiles read_surroundings_files(const CheckedTable& deck,
                                          const TableFiles& files,
                                          FaultList& faults,
                                          std::vector<MeshRecord>& records);

}  // namespace gxrod
