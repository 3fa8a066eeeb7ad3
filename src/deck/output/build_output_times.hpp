#pragma once

#include "deck/places/build_context.hpp"
#include "model/settings/settings.hpp"

namespace gxrod {

// The times at which [output] asks for frames and for samples of histories. After the stages.
void build_output_times(const CheckedTable& table, const BuildContext& context, OutputSettings& output);

}  // namespace gxrod
