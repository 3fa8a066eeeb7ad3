#pragma once

#include <variant>

#include "state/eigenvalue_record.hpp"
#include "state/mode_record.hpp"
#include "state/response_record.hpp"

namespace gxrod {

// What a stage that finds shapes has found.
using ShapesRecord = std::variant<ModesRecord, BucklingRecord, EigenvaluesRecord, ResponseRecord>;

}  // namespace gxrod
