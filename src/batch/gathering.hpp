#pragma once

#include "batch/batch_lock.hpp"
#include "batch/batch_record.hpp"
#include "batch/cases/case_row.hpp"

// Slices of a batch write parts of the table; the holder of the table's lock merges them. A slice begins its
// part after merging those that are idle, while its cases are locked, so that no two parts have the same
// case.
namespace gxrod {

// Whether there are parts that no process writes, except perhaps the holder of `lock`.
bool has_idle_parts(const std::filesystem::path& folder, const BatchLock& lock);

// Makes index.csv of all rows that a folder has, and removes the parts that are idle as above.
// The table must be locked. Throws FileError.
std::vector<CaseRow> gather_parts(const std::filesystem::path& folder,
                                  const BatchRecord& record,
                                  const BatchLock& lock);

}  // namespace gxrod
