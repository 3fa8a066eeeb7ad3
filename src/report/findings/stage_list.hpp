#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// A group of /stages.
struct FoundStage {
    std::string name;
    std::string kind;           // as decks say it
    std::size_t number = 0;     // among the stages of the deck
    std::size_t first_row = 0;  // of the histories; of a stage that takes no steps, rows before it

    std::string group() const { return "/stages/" + name; }
    bool has(const Hdf5Reader& file, const std::string& member) const;
};

// In their order; none of results without /stages. Throws Hdf5Error.
std::vector<FoundStage> list_stages(const Hdf5Reader& file);

// The last row of the histories before a stage; 0 before the first.
std::size_t row_before(const FoundStage& stage);
// The row whose state a stage that takes no steps is about: after a path, that where its main path ends.
// Throws Hdf5Error.
std::size_t find_row_of_state(const Hdf5Reader& file, const FoundStage& stage);

// [{name, kind, from, until}] of a deck with stages, on the axis of the results; empty otherwise. `times` has
// that axis, one number a row. Throws Hdf5Error.
nlohmann::ordered_json describe_stages(const Hdf5Reader& file,
                                       const std::vector<FoundStage>& stages,
                                       const std::vector<double>& times);

}  // namespace gxrod
