#pragma once

#include "verification/study.hpp"

// The integrators on flexible rods, which Rubin (2007) asked for and did not show: what each costs for what
// error of orientation, energy and momentum.
namespace gxrod::rod_schemes {

StudyResult report(const StudyOptions& options);

}  // namespace gxrod::rod_schemes
