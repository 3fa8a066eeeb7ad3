#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "batch/cases/case_table.hpp"

namespace gxrod {

// An array job, each of whose tasks runs a slice of a batch.
struct SlurmScript {
    std::string name;                 // name of the job
    std::filesystem::path program;    // gxrod
    std::filesystem::path directory;  // where it runs
    std::vector<std::string> files;   // plan or decks, as the user named them in that directory
    std::filesystem::path folder;     // folder of the batch, absolute
    std::vector<CaseRange> slices;    // cases of task 1, 2, …
    bool retry_failed = false;
};

// Writes the script for sbatch. Throws FileError if sbatch cannot read a path.
std::string write_slurm_script(const SlurmScript& script);

// Makes the name of a job: letters, digits, points, dashes and underscores; anything else becomes an
// underscore.
std::string make_job_name(const std::string& text);

// Quotes a word of a command for bash, if it needs quotes.
std::string quote_for_shell(std::string_view word);

// Chooses the number of tasks: at least four cases per core of a task, and at most a hundred tasks. The
// options of sbatch set the cores of a task.
long choose_task_count(long cases, const std::vector<std::string>& sbatch_options);

}  // namespace gxrod
