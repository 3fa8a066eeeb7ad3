#pragma once

#include <functional>

#include "batch/cases/case_run.hpp"
#include "batch/cases/case_table.hpp"

namespace gxrod {

// Results files that the cases of a range leave, as far as is known beforehand (results/results_size.hpp).
struct KeptResults {
    double bytes = 0.0;
    double frames = 0.0;
    long unknown = 0;  // cases with adaptive steps, which add more
};

struct CheckedCases {
    std::string title;                // of the first
    std::vector<MeshDigests> meshes;  // of each deck
    KeptResults kept;
};

// Reads, builds and examines cases, as `gxrod check` does, so that what is wrong with one shows before any is
// run: the first, and those of `range`. `report` hears how many were examined. Throws DeckError, each fault
// once, with the cases that have it, at the plan's key or the table's row where that gave the value;
// FileError where a mesh cannot be read.
CheckedCases check_cases(const CaseContext& context,
                         const CaseRange& range,
                         const std::function<void(long)>& report);

}  // namespace gxrod
