#pragma once

#include <fcntl.h>

#include <chrono>
#include <filesystem>
#include <vector>

#include "batch/cases/case_table.hpp"

namespace gxrod {

// Prevents two processes from running the same cases of a folder, also on different machines if the file
// system has locks. Held until the object is destroyed, or its process and workers end.
class BatchLock {
  public:
    // Locks cases. Throws FileError if any of them is being run, and still is after two seconds.
    static BatchLock of_cases(const std::filesystem::path& folder, const CaseRange& range);
    // Locks the table index.csv; waits for it for at most ten minutes. Throws FileError.
    static BatchLock of_table(const std::filesystem::path& folder);

    // Locks the submission of cases to a cluster. Throws FileError if another process is submitting.
    static BatchLock of_submission(const std::filesystem::path& folder);

    // List the cases that processes are running; the second leaves out cases that the holder of this lock has
    // locked.
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
