#pragma once

#include "batch/cases/case_row.hpp"
#include "batch/slurm/slurm.hpp"
#include "batch/slurm/slurm_script.hpp"

// A batch whose cases are run by array jobs of Slurm.
namespace gxrod {

// Which cases of a batch are taken. It is asked before the table is read: a task that ends in between has
// left its rows.
struct CaseHolders {
    std::vector<SlurmTask> tasks;  // that Slurm still has
    std::vector<CaseRange> taken;  // cases of these tasks, and those that processes run now
};

// Throws SlurmError if there are jobs and Slurm does not say what became of them.
CaseHolders find_holders(const std::filesystem::path& folder, const std::vector<SlurmJob>& jobs, long cases);

// Cases that are not done.
struct Remainder {
    std::vector<long> missing;       // without a row, and not taken
    std::vector<long> failed;        // not taken
    std::vector<long> failed_again;  // the same, after a job was to run them once more
    long taken = 0;

    bool is_empty() const { return missing.empty() && failed.empty() && failed_again.empty() && taken == 0; }
};

// `rows` in ascending order.
Remainder find_remainder(const std::vector<CaseRow>& rows,
                         long cases,
                         const std::vector<CaseRange>& taken,
                         const std::vector<SlurmJob>& jobs);

struct Submission {
    SlurmScript script;
    std::string file;                  // the script's name
    std::vector<std::string> options;  // of sbatch
    std::vector<CaseRange> retried;    // of the cases, those that have a row
};

// Writes the script, submits it and adds the job to those of the folder. Throws FileError, then nothing was
// submitted or the message says what was.
SlurmJob submit(const Submission& submission, std::vector<SlurmJob> jobs);

}  // namespace gxrod
