#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "batch/slurm/slurm_jobs.hpp"
#include "machine/file_error.hpp"

namespace gxrod {

// Thrown if a command of Slurm is missing, does not answer or refuses.
class SlurmError : public FileError {
  public:
    using FileError::FileError;
};

bool has_slurm();

// Submits a script and returns the job's id and cluster. Throws SlurmError.
SlurmJob submit_to_slurm(const std::filesystem::path& script, const std::vector<std::string>& options);

// Returns the tasks of these jobs that wait, run or end. Without jobs it runs no command. Throws SlurmError.
std::vector<SlurmTask> ask_slurm(const std::vector<SlurmJob>& jobs);

}  // namespace gxrod
