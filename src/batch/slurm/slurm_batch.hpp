#pragma once

#include "batch/cases/case_row.hpp"
#include "batch/slurm/slurm.hpp"
#include "batch/slurm/slurm_script.hpp"

// A batch whose cases array jobs of Slurm run.
namespace gxrod {

// The cases of a batch that are taken. Find them before the table is read: a task that ends in between has
// then left its rows.
struct CaseHolders {
    std::vector<SlurmTask> tasks;  // tasks that Slurm still has
    std::vector<CaseRange> taken;  // cases of these tasks and of processes that run now
};

// Finds them. Throws SlurmError if there are jobs and Slurm does not report their state.
CaseHolders find_holders(const std::filesystem::path& folder, const std::vector<SlurmJob>& jobs, long cases);

// Cases that are not done.
struct Remainder {
    std::vector<long> missing;       // without a row, and not taken
    std::vector<long> failed;        // not taken
    std::vector<long> failed_again;  // not taken, and a job was to run them once more
    long taken = 0;

    bool is_empty() const { return missing.empty() && failed.empty() && failed_again.empty() && taken == 0; }
};

// Finds the remainder; `rows` must be in ascending order.
Remainder find_remainder(const std::vector<CaseRow>& rows,
                         long cases,
                         const std::vector<CaseRange>& taken,
                         const std::vector<SlurmJob>& jobs);

struct Submission {
    SlurmScript script;
    std::string file;                  // the script's name
    std::vector<std::string> options;  // options of sbatch
    std::vector<CaseRange> retried;    // cases that have a row
};

// Writes the script, submits it and adds the job to the jobs of the folder. Throws FileError: either nothing
// was submitted or the message names the job.
SlurmJob submit(const Submission& submission, std::vector<SlurmJob> jobs);

}  // namespace gxrod
