#pragma once

#include <functional>

#include "batch/cases/case_run.hpp"
#include "batch/cases/case_table.hpp"

namespace gxrod {

// The size of results files of the cases of a range, as far as known in advance (results/results_size.hpp).
struct KeptResults {
    double bytes = 0.0;
    double frames = 0.0;
    long unknown = 0;  // cases with adaptive steps, which add more
};

struct CheckedCases {
    std::string title;                // title of the first case
    std::vector<MeshDigests> meshes;  // meshes of each deck
    KeptResults kept;
};

// Reads, builds and examines cases as `gxrod check` does, so that faults show before any case runs: the first
// case and the cases of `range`. Calls `report` with the number examined so far. Throws DeckError with each
// fault once and the cases that have it, at the plan's key or the table's row if that gave the value;
// FileError if a mesh cannot be read.
CheckedCases check_cases(const CaseContext& context,
                         const CaseRange& range,
                         const std::function<void(long)>& report);

}  // namespace gxrod
