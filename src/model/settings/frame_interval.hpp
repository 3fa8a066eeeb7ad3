#pragma once

#include "model/settings/settings.hpp"

// The default interval of frames: a few hundred of them show any motion.
namespace gxrod {

// The largest number of frames after the first one, and the number of intervals of time that get a frame with
// adaptive steps.
inline constexpr long default_frames = 500;

// Chooses OutputSettings::every for an analysis: 1, 2, 5, 10, 20, 50 …; 0, by the time, if the number of
// steps is not known beforehand, but 1 for a path.
long choose_frame_interval(const AnalysisSettings& analysis);

// With `every` 0: whether a step from one time to a later one ends in a different interval of time than it
// began.
bool is_frame_time(double before, double after, double end_time);

}  // namespace gxrod
