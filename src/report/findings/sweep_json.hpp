#pragma once

#include <nlohmann/json_fwd.hpp>

#include "report/findings/stage_list.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Returns whether a stage has followed eigenvalues over a number of the deck.
bool has_sweep(const Hdf5Reader& file, const FoundStage& stage);

// Returns {stage, key, values, speeds, words, omega, growth, onsets}: omega and growth have a list for each
// mode, null where it was lost; onsets are {value, omega, kind, begins}. Throws Hdf5Error.
nlohmann::ordered_json describe_sweep(const Hdf5Reader& file, const FoundStage& stage);

}  // namespace gxrod
