#pragma once

#include <optional>
#include <string>

#include "deck/table/kinds.hpp"

// [function.NAME].
namespace gxrod {

struct FunctionTable : TableHead {
    std::optional<TimeTable> table;
    std::optional<std::string> file;
    std::optional<FileColumns> columns;
    std::optional<CheckedTimeFunction> expression;
    std::optional<Interpolation> interpolation;
};

}  // namespace gxrod
