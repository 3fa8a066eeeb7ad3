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

// Returns whether the record holds shapes about one state: responses have none, and those of sweeps, if they
// are kept, are about several.
inline bool has_shapes(const ShapesRecord& record) {
    return !std::holds_alternative<ResponseRecord>(record) && !std::holds_alternative<SweepRecord>(record);
}

}  // namespace gxrod
