#pragma once

#include <cstddef>
#include <string>

namespace gxrod {

// A stage as results name it.
struct StagePlace {
    std::size_t index;  // from 0
    std::string name;
    std::string kind;   // as decks say it
    double axis_start;  // where its t begins on the axis of the results
};

}  // namespace gxrod
