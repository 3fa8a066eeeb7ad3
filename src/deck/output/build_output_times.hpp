#pragma once

#include "deck/places/build_context.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// Builds the times of frames and of samples of histories from [output]. Call it after the stages.
void build_output_times(const CheckedTable& table, const BuildContext& context, OutputSettings& output);

}  // namespace gxrod
