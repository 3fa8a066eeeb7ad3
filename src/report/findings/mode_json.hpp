#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "report/findings/stage_list.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Whether a stage has found modes of vibration or of buckling, or eigenvalues.
bool has_modes(const Hdf5Reader& file, const FoundStage& stage);
// How many. Throws Hdf5Error.
std::size_t count_modes(const Hdf5Reader& file, const FoundStage& stage);

// {stage, kind, words} and, as far as the stage has them, a list each of frequency, omega, growth,
// damping_ratio, factor and mass_shares: along and about x, y, z, of the whole model's; complete and
// unstable. Throws Hdf5Error.
nlohmann::ordered_json describe_modes(const Hdf5Reader& file, const FoundStage& stage);

}  // namespace gxrod
