#pragma once

#include <string>

namespace gxrod {

enum class Severity {
    note,
    warning,  // results may be misleading: a run repeats it, and its file and summary list it
    error     // the analysis cannot be run
};

struct Finding {
    Severity severity;
    std::string message;
};

}  // namespace gxrod
