#pragma once

#include "verification/study.hpp"

// A comparison of the integrators on flexible rods, which Rubin (2007) called for but did not show: cost and
// errors of orientation, energy and momentum.
namespace gxrod::rod_schemes {

StudyResult report(const StudyOptions& options);

}  // namespace gxrod::rod_schemes
