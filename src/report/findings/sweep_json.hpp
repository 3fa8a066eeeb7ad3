#pragma once

#include <nlohmann/json_fwd.hpp>

#include "report/findings/stage_list.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Returns whether a stage has followed eigenvalues over a number of the deck.
bool has_sweep(const Hdf5Reader& file, const FoundStage& stage);
// Counts the shapes that it keeps, one for each value and mode.
std::size_t count_sweep_shapes(const Hdf5Reader& file, const FoundStage& stage);

// Returns {stage, key, values, speeds, words, words_at_values, omega, growth, onsets}: words at values, omega
// and growth have a list for each mode, "" or null where it was lost; onsets are {value, omega, kind,
// begins}. Throws Hdf5Error.
nlohmann::ordered_json describe_sweep(const Hdf5Reader& file, const FoundStage& stage);

}  // namespace gxrod
