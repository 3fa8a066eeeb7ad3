#pragma once

#include <string>

namespace gxrod::test {

// The bytes of a results file of a rod and a body, with a few steps and frames, as gxrod itself writes it;
// made once.
const std::string& results_sample();

}  // namespace gxrod::test
