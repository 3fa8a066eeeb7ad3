#pragma once

#include <variant>

#include "state/records/eigenvalue_record.hpp"
#include "state/records/mode_record.hpp"
#include "state/records/response_record.hpp"
#include "state/records/sweep_record.hpp"

namespace gxrod {

// What a stage that finds shapes has found.
using ShapesRecord =
    std::variant<ModesRecord, BucklingRecord, EigenvaluesRecord, ResponseRecord, SweepRecord>;

// A response has none of its own, and a sweep keeps none.
inline bool has_shapes(const ShapesRecord& record) {
    return !std::holds_alternative<ResponseRecord>(record) && !std::holds_alternative<SweepRecord>(record);
}

}  // namespace gxrod
