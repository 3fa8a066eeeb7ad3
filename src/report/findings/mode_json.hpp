#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "report/findings/stage_list.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Returns whether a stage has found modes of vibration or buckling, or eigenvalues.
bool has_modes(const Hdf5Reader& file, const FoundStage& stage);
// Counts them. Throws Hdf5Error.
std::size_t count_modes(const Hdf5Reader& file, const FoundStage& stage);

// Describes a stage: {stage, kind, words} and, if the stage has them, lists of frequency, omega, growth,
// damping_ratio, factor and mass_shares (of the whole model, along and about x, y, z); complete and unstable.
// Throws Hdf5Error.
nlohmann::ordered_json describe_modes(const Hdf5Reader& file, const FoundStage& stage);

}  // namespace gxrod
