#pragma once

#include <filesystem>
#include <vector>

#include "batch/case_row.hpp"

namespace gxrod {

// Writes index.h5, the table for programs: a dataset each for case, status, reason, /parameters/KEY,
// /collected/NAME, steps, newton_iterations, rejected_steps, time, seconds, results and warning, one entry a
// row; attributes say what the batch is. A parameter whose values are all numbers has numbers. It replaces an
// earlier one at once. Throws FileError.
void write_batch_index(const std::filesystem::path& folder,
                       const BatchRecord& record,
                       const std::vector<CaseRow>& rows);

}  // namespace gxrod
