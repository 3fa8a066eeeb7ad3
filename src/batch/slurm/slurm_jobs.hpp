#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "batch/cases/case_table.hpp"

// The array jobs of a batch that were submitted to Slurm: DIR/slurm/jobs.json.
namespace gxrod {

struct SlurmJob {
    std::string id;
    std::string cluster;               // "" for the default cluster
    std::string script;                // its file name
    std::string submitted;             // "2024-05-17 09:30:00"
    std::vector<std::string> options;  // options of sbatch
    std::vector<CaseRange> slices;     // cases of task 1, 2, …
    std::vector<CaseRange> retried;    // cases that had a row, and were not done

    bool operator==(const SlurmJob&) const = default;
};

// Returns the folder of scripts, the list of jobs and the output of tasks.
std::filesystem::path slurm_folder(const std::filesystem::path& folder);

// Reads the jobs in the order of their submission; none if none was submitted. Throws FileError.
std::vector<SlurmJob> read_slurm_jobs(const std::filesystem::path& folder);
void write_slurm_jobs(const std::vector<SlurmJob>& jobs, const std::filesystem::path& folder);

// Reads the output of sbatch --parsable: "17", or "17;cluster". An empty id if it is something else.
SlurmJob read_submission(std::string_view text);

// A task that Slurm still has, whether it waits, runs or ends.
struct SlurmTask {
    std::string job;
    std::string state;   // "PENDING", "RUNNING" …
    std::string reason;  // why it waits
    CaseRange slice;

    bool operator==(const SlurmTask&) const = default;
};

// Reads the output of squeue in this form for array jobs, one task per line; other lines are skipped.
inline constexpr const char* squeue_format = "%F|%K|%T|%r";
std::vector<SlurmTask> read_squeue(std::string_view text, const std::vector<SlurmJob>& jobs);

}  // namespace gxrod
