#pragma once

#include "deck/places/build_context.hpp"
#include "model/settings/settings.hpp"

// [output].
namespace gxrod {

// Sets how many steps lie between frames in each stage. Call it after choose_schemes.
void set_frame_intervals(BuildContext& context);

// Returns whether [output] asks for stresses.
bool records_stresses(const CheckedTable& deck);

// Builds the settings of [output], with the histories of line_ends but without those of [[history]]. Call it
// after set_frame_intervals.
OutputSettings build_output(const BuildContext& context);

}  // namespace gxrod
