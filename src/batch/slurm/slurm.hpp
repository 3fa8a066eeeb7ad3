#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "batch/slurm/slurm_jobs.hpp"
#include "machine/file_error.hpp"

namespace gxrod {

// A command of Slurm is missing, does not answer or refuses.
class SlurmError : public FileError {
  public:
    using FileError::FileError;
};

bool has_slurm();

// Submits a script and returns the job's id and cluster. Throws SlurmError.
SlurmJob submit_to_slurm(const std::filesystem::path& script, const std::vector<std::string>& options);

// The tasks of these jobs that wait, run or end. Throws SlurmError. Without jobs, runs nothing.
std::vector<SlurmTask> ask_slurm(const std::vector<SlurmJob>& jobs);

}  // namespace gxrod
