#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "batch/cases/case_table.hpp"

namespace gxrod {

// An array job, each of whose tasks runs a slice of a batch.
struct SlurmScript {
    std::string name;                 // of the job
    std::filesystem::path program;    // gxrod
    std::filesystem::path directory;  // in which it is run
    std::vector<std::string> files;   // plan or decks, as the user named them there
    std::filesystem::path folder;     // of the batch, absolute
    std::vector<CaseRange> slices;    // of task 1, 2, …
    bool retry_failed = false;
};

// The text that sbatch reads. Throws FileError if a path holds what sbatch cannot read.
std::string write_slurm_script(const SlurmScript& script);

// A name of a job: letters, digits, points, dashes and underscores; anything else becomes an underscore.
std::string make_job_name(const std::string& text);

// A word of a command, as bash reads it; in quotes if it needs them.
std::string quote_for_shell(std::string_view word);

// Tasks for so many cases: at least four cases a core and task, and at most a hundred tasks. The options of
// sbatch say how many cores a task has.
long choose_task_count(long cases, const std::vector<std::string>& sbatch_options);

}  // namespace gxrod
