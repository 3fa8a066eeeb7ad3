#include "batch/slurm/slurm_batch.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include "batch/batch_folder.hpp"
#include "batch/batch_lock.hpp"
#include "batch/cases/case_slices.hpp"

namespace gxrod {
namespace {

namespace fs = std::filesystem;

std::string describe_now() { return fmt::format("{:%F %T}", fmt::localtime(std::time(nullptr))); }

}  // namespace

CaseHolders find_holders(const fs::path& folder, const std::vector<SlurmJob>& jobs, long cases) {
    CaseHolders holders;
    holders.tasks = ask_slurm(jobs);
    std::error_code ignored;
    if (fs::exists(folder, ignored)) holders.taken = BatchLock::list_running(folder, {1, cases});
    for (const SlurmTask& task : holders.tasks) holders.taken.push_back(task.slice);
    return holders;
}

Remainder find_remainder(const std::vector<CaseRow>& rows,
                         long cases,
                         const std::vector<CaseRange>& taken,
                         const std::vector<SlurmJob>& jobs) {
    std::vector<CaseRange> retried;
    for (const SlurmJob& job : jobs) retried.insert(retried.end(), job.retried.begin(), job.retried.end());
    Remainder remainder;
    auto row = rows.begin();
    for (long number = 1; number <= cases; ++number) {
        const bool has_row = row != rows.end() && row->number == number;
        const bool is_done = has_row && row->status == CaseStatus::done;
        if (has_row) ++row;
        if (is_done) continue;
        if (contain(taken, number)) {
            ++remainder.taken;
        } else if (!has_row) {
            remainder.missing.push_back(number);
        } else {
            (contain(retried, number) ? remainder.failed_again : remainder.failed).push_back(number);
        }
    }
    return remainder;
}

SlurmJob submit(const Submission& submission, std::vector<SlurmJob> jobs) {
    const fs::path& folder = submission.script.folder;
    const fs::path script = slurm_folder(folder) / submission.file;
    const std::string text = write_slurm_script(submission.script);
    make_folder(slurm_folder(folder));
    write_slurm_jobs(jobs, folder);  // now, to find out that it can be written
    replace_file(script, text);
    SlurmJob job;
    try {
        job = submit_to_slurm(script, submission.options);
    } catch (...) {
        std::error_code ignored;
        fs::remove(script, ignored);
        throw;
    }
    job.script = submission.file;
    job.submitted = describe_now();
    job.options = submission.options;
    job.slices = submission.script.slices;
    job.retried = submission.retried;
    jobs.push_back(job);
    try {
        write_slurm_jobs(jobs, folder);
    } catch (const FileError& error) {
        throw FileError(
            error.path(),
            fmt::format("job {} was submitted but cannot be written down: {}", job.id, error.what()),
            "scancel " + job.id);
    }
    return job;
}

}  // namespace gxrod
