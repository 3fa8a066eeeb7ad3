#pragma once

#include "model/settings/settings.hpp"

// How often a frame is written where the deck does not say: a few hundred of them show any motion.
namespace gxrod {

// Frames after the first one, at most, and parts of the time of adaptive steps that get one each.
inline constexpr long default_frames = 500;

// OutputSettings::every for an analysis: 1, 2, 5, 10, 20, 50 …, or 0, by the time, where the number of steps
// is not known beforehand; 1 of a path then.
long choose_frame_interval(const AnalysisSettings& analysis);

// With `every` 0: whether a step from one time to a later one ends in another of the equal parts of the time
// than it began.
bool is_frame_time(double before, double after, double end_time);

}  // namespace gxrod
