#pragma once

#include <variant>

#include "state/records/eigenvalue_record.hpp"
#include "state/records/mode_record.hpp"
#include "state/records/response_record.hpp"
#include "state/records/sweep_record.hpp"

namespace gxrod {

// The results of a stage that finds shapes.
using ShapesRecord =
    std::variant<ModesRecord, BucklingRecord, EigenvaluesRecord, ResponseRecord, SweepRecord>;

// Returns whether the record holds shapes: responses have none, and sweeps keep none.
inline bool has_shapes(const ShapesRecord& record) {
    return !std::holds_alternative<ResponseRecord>(record) && !std::holds_alternative<SweepRecord>(record);
}

}  // namespace gxrod
