#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// A group of /stages.
struct FoundStage {
    std::string name;
    std::string kind;           // the deck's word
    std::size_t number = 0;     // among the stages of the deck
    std::size_t first_row = 0;  // row of the histories; for a stage without steps, number of rows before it

    std::string group() const { return "/stages/" + name; }
    bool has(const Hdf5Reader& file, const std::string& member) const;
};

// Lists the stages in order; none if the results have no /stages. Throws Hdf5Error.
std::vector<FoundStage> list_stages(const Hdf5Reader& file);

// Returns the last row of the histories before a stage; 0 before the first.
std::size_t row_before(const FoundStage& stage);
// Finds the row of the state that a stage without steps examines: after a path, the end of its main path.
// Throws Hdf5Error.
std::size_t find_row_of_state(const Hdf5Reader& file, const FoundStage& stage);

// Returns [{name, kind, from, until}] for a deck with stages, on the axis of the results; empty otherwise.
// `times` holds that axis, one number per row. Throws Hdf5Error.
nlohmann::ordered_json describe_stages(const Hdf5Reader& file,
                                       const std::vector<FoundStage>& stages,
                                       const std::vector<double>& times);

}  // namespace gxrod
