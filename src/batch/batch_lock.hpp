#pragma once

#include <fcntl.h>

#include <chrono>
#include <filesystem>
#include <vector>

#include "batch/cases/case_table.hpp"

namespace gxrod {

// Keeps two processes from running the same cases of a folder, also on several machines if the file system
// has locks. Held until the object is destroyed, or its process dies with its workers.
class BatchLock {
  public:
    // Of cases. Throws FileError if any of them is being run, and still is after two seconds.
    static BatchLock of_cases(const std::filesystem::path& folder, const CaseRange& range);
    // Of the table index.csv; waits for it, ten minutes at most. Throws FileError.
    static BatchLock of_table(const std::filesystem::path& folder);

    // Of submitting cases to a cluster. Throws FileError if another process does.
    static BatchLock of_submission(const std::filesystem::path& folder);

    // The cases that processes run; the second leaves out those that the holder of this lock has locked.
    static std::vector<CaseRange> list_running(const std::filesystem::path& folder, const CaseRange& range);
    std::vector<CaseRange> list_running(const CaseRange& range) const;

    ~BatchLock();
    BatchLock(BatchLock&& other) noexcept;
    BatchLock& operator=(BatchLock&&) = delete;

  private:
    explicit BatchLock(int descriptor) : descriptor_(descriptor) {}
    static BatchLock acquire(const std::filesystem::path& folder,
                             struct flock lock,
                             std::chrono::seconds patience);

    int descriptor_;
};

}  // namespace gxrod
