#pragma once

#include <string>
#include <vector>

#include "watch/stress_watch.hpp"

namespace gxrod {

struct StressWords {
    std::vector<std::string> findings;  // a sentence each
    std::vector<std::string> warnings;  // where a material fails
};

// Says where and when the largest von Mises stress and the largest exposure of a run were.
StressWords describe_stresses(const Model& model, const StressWatch& watch, const StressEnvelope& envelope);

}  // namespace gxrod
