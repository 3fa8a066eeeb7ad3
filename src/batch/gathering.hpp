#pragma once

#include "batch/batch_lock.hpp"
#include "batch/batch_record.hpp"
#include "batch/cases/case_row.hpp"

// Slices of a batch write parts of the table; the holder of the table's lock merges them. A slice locks its
// cases and merges idle parts before it begins its own part, so no two parts have the same case.
namespace gxrod {

// Returns whether there are parts that no process writes, except perhaps the holder of `lock`.
bool has_idle_parts(const std::filesystem::path& folder, const BatchLock& lock);

// Makes index.csv of all rows in a folder, and removes idle parts. The table must be locked. Throws
// FileError.
std::vector<CaseRow> gather_parts(const std::filesystem::path& folder,
                                  const BatchRecord& record,
                                  const BatchLock& lock);

}  // namespace gxrod
