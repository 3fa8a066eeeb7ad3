#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batch/batch.hpp"
#include "exit_code.hpp"

namespace gxrod {

// What `gxrod batch` was asked for with --slurm or --gather.
struct SlurmArguments {
    std::vector<std::string> files;
    std::filesystem::path folder;
    bool has_folder = false;  // the user named it
    // Of sbatch, if any were given; --gather takes those of the last job otherwise.
    std::optional<std::vector<std::string>> options;
    long tasks = 0;  // 0 for as many as suit the cases
    bool retry_failed = false;
    bool dry_run = false;
    bool begin_anew = false;
    bool quiet = false;
};

// Submits an array job of what is left of a batch. Throws FileError.
ExitCode submit_batch(const PreparedBatch& batch, const SlurmArguments& arguments);

// Completes the table, reports progress, and submits the cases that are left and not taken. Throws FileError.
ExitCode gather_batch(const PreparedBatch& batch, const SlurmArguments& arguments);

}  // namespace gxrod
