#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/text/fault_list.hpp"
#include "deck/text/table_files.hpp"
#include "environment/sea.hpp"
#include "model/surroundings.hpp"

// Files of waves and of the ground that a deck names.
namespace gxrod {

struct SurroundingsFiles {
    std::map<std::size_t, ElevationRecord> waves{};  // by index of [[wave]]
    std::optional<GroundGrid> ground{};
};

// What is wrong with a file is thrown as FileError, each text beginning with "file:line".
// Of a record the elevations and their times.
ElevationRecord read_elevations(std::string_view bytes, const std::string& file);
GroundGrid read_ground_grid(std::string_view bytes, const std::string& file);

// What is wrong with a file goes to the faults. `records` gets the files' bytes.
SurroundingsFiles read_surroundings_files(const CheckedTable& deck,
                                          const TableFiles& files,
                                          FaultList& faults,
                                          std::vector<MeshRecord>& records);

}  // namespace gxrod
