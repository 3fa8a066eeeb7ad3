#pragma once

#include <cstddef>
#include <string>

namespace gxrod {

// A stage and its place in the results.
struct StagePlace {
    std::size_t index;  // from 0
    std::string name;
    std::string kind;   // the deck's word
    double axis_start;  // where t = 0 of the stage lies on the axis of the results
};

}  // namespace gxrod
