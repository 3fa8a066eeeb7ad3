#pragma once

#include "batch/slurm/slurm_batch.hpp"

// What `gxrod batch --slurm` and `--gather` print on standard output.
namespace gxrod {

// Which tasks Slurm has, and how many cases are not done but taken.
void print_holders(const CaseHolders& holders, long taken);

// The script and the command that would submit it.
void print_script(const Submission& submission);

// `gather_command` completes the table afterwards.
void print_job(const SlurmJob& job,
               const Submission& submission,
               std::size_t cases,
               const std::string& gather_command);

// The table so far; failures on standard error.
void print_table(const std::filesystem::path& folder, const std::vector<CaseRow>& rows, long cases);

}  // namespace gxrod
