#pragma once

#include <nlohmann/json_fwd.hpp>

#include "report/findings/stage_list.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Whether a stage has followed eigenvalues over a number of the deck.
bool has_sweep(const Hdf5Reader& file, const FoundStage& stage);

// {stage, key, values, speeds, words, omega, growth, onsets}: of omega and growth a list for each mode, null
// where it was lost; of onsets {value, omega, kind, begins}. Throws Hdf5Error.
nlohmann::ordered_json describe_sweep(const Hdf5Reader& file, const FoundStage& stage);

}  // namespace gxrod
