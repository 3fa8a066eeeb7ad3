#include "batch_slurm.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "batch/batch_lock.hpp"
#include "batch/cases/case_slices.hpp"
#include "batch_output.hpp"
#include "batch_slurm_output.hpp"
#include "say.hpp"

namespace gxrod {

namespace {

namespace fs = std::filesystem;
using Options = std::vector<std::string>;  // of sbatch

// --slurm or --gather of one folder.
class SlurmBatch {
  public:
    SlurmBatch(const PreparedBatch& batch, const SlurmArguments& arguments)
        : batch_(batch), arguments_(arguments), folder_(arguments.folder), cases_(batch.cases().count()) {}

    ExitCode submit();
    ExitCode gather();

  private:
    bool prints() const { return !arguments_.quiet; }
    void begin();
    ExitCode report_nothing_to_submit(const CaseHolders& holders, const Remainder& left) const;
    void submit_rest(const CaseHolders& holders, const Remainder& left) const;
    void submit(const CaseHolders& holders,
                const std::vector<long>& missing,
                const std::vector<long>& failed,
                const Options& default_options) const;
    Submission make_submission(const CaseHolders& holders,
                               const std::vector<long>& missing,
                               const std::vector<long>& failed,
                               const Options& default_options) const;
    std::string make_job_name() const;
    std::string gather_command() const;

    const PreparedBatch& batch_;
    const SlurmArguments& arguments_;
    const fs::path& folder_;
    long cases_;
    std::optional<BatchLock> lock_;
    std::vector<SlurmJob> jobs_;  // before this run
};

// Without "/" at its end.
fs::path make_absolute(const fs::path& folder) {
    const fs::path path = fs::absolute(folder).lexically_normal();
    return path.has_filename() ? path : path.parent_path();
}

std::vector<long> merge(const std::vector<long>& a, const std::vector<long>& b) {
    std::vector<long> all;
    std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
    return all;
}

void check_no_tasks(const std::vector<SlurmTask>& tasks, const fs::path& folder) {
    if (tasks.empty()) return;
    throw FileError(folder,
                    fmt::format("job {} has tasks of the batch that --force would throw away", tasks[0].job),
                    "scancel " + tasks[0].job);
}

ExitCode SlurmBatch::submit() {
    begin();
    const CaseHolders holders = find_holders(folder_, jobs_, cases_);
    const bool is_anew = arguments_.begin_anew && arguments_.dry_run;
    const std::vector<CaseRow> rows = is_anew ? std::vector<CaseRow>() : batch_.read_rows(folder_);
    const Remainder left = find_remainder(rows, cases_, holders.taken, jobs_);
    const std::vector<long> failed =
        arguments_.retry_failed ? merge(left.failed, left.failed_again) : std::vector<long>();
    if (left.missing.empty() && failed.empty()) return report_nothing_to_submit(holders, left);
    if (prints()) print_holders(holders, left.taken);
    submit(holders, left.missing, failed, {});
    return exit_done;
}

void SlurmBatch::begin() {
    if (arguments_.begin_anew) check_no_tasks(ask_slurm(read_slurm_jobs(folder_)), folder_);
    if (!arguments_.dry_run) {
        begin_batch(batch_, folder_, arguments_.begin_anew);
        lock_.emplace(BatchLock::of_submission(folder_));
    }
    jobs_ = read_slurm_jobs(folder_);
}

ExitCode SlurmBatch::report_nothing_to_submit(const CaseHolders& holders, const Remainder& left) const {
    const std::size_t failed = left.failed.size() + left.failed_again.size();
    if (left.taken == 0 && failed == 0) {
        if (prints()) say(stdout, "All cases are done; there is nothing to submit.\n");
        return exit_done;
    }
    if (!prints()) return exit_not_converged;
    say(stdout, "Nothing was submitted.\n");
    print_holders(holders, left.taken);
    if (failed > 0) say(stdout, "{} failed; --retry-failed submits them again.\n", count_cases(failed));
    return exit_not_converged;
}

ExitCode SlurmBatch::gather() {
    if (!is_batch_folder(folder_)) throw FileError(folder_, "holds no batch yet", "--slurm starts one");
    batch_.read_rows(folder_);  // throws if it is another batch
    lock_.emplace(BatchLock::of_submission(folder_));
    jobs_ = read_slurm_jobs(folder_);
    CaseHolders holders;
    std::string fault;
    try {
        holders = find_holders(folder_, jobs_, cases_);
    } catch (const SlurmError& error) {
        fault = error.what();
    }
    const std::vector<CaseRow> rows = gather_rows(folder_, batch_.record());
    if (prints()) print_table(folder_, rows, cases_);
    const Remainder left = find_remainder(rows, cases_, holders.taken, jobs_);
    if (left.is_empty()) return exit_done;
    if (fault.empty()) {
        if (prints()) print_holders(holders, left.taken);
        submit_rest(holders, left);
    } else {
        say(stderr, "gxrod: nothing was submitted: {}\n", fault);
    }
    return exit_not_converged;
}

void SlurmBatch::submit_rest(const CaseHolders& holders, const Remainder& left) const {
    if (prints() && !arguments_.retry_failed && !left.failed_again.empty()) {
        say(stdout,
            "{} still not done after a repeated job; --retry-failed submits them again.\n",
            count_cases(left.failed_again.size()));
    }
    const std::vector<long> failed =
        arguments_.retry_failed ? merge(left.failed, left.failed_again) : left.failed;
    const std::size_t cases = left.missing.size() + failed.size();
    if (cases == 0) return;
    if (arguments_.dry_run) {
        say(stdout, "{} to submit again\n", count_cases(cases));
    } else if (has_slurm()) {
        submit(holders, left.missing, failed, jobs_.empty() ? Options() : jobs_.back().options);
    } else {
        say(stderr, "gxrod: nothing was submitted: there is no sbatch on this machine\n");
    }
}

void SlurmBatch::submit(const CaseHolders& holders,
                        const std::vector<long>& missing,
                        const std::vector<long>& failed,
                        const Options& default_options) const {
    const Submission submission = make_submission(holders, missing, failed, default_options);
    if (arguments_.dry_run) {
        print_script(submission);
        return;
    }
    const SlurmJob job = gxrod::submit(submission, jobs_);
    if (prints()) print_job(job, submission, missing.size() + failed.size(), gather_command());
}

Submission SlurmBatch::make_submission(const CaseHolders& holders,
                                       const std::vector<long>& missing,
                                       const std::vector<long>& failed,
                                       const Options& default_options) const {
    const std::vector<long> cases = merge(missing, failed);
    Submission submission;
    submission.options = arguments_.options.value_or(default_options);
    submission.retried = join_numbers(failed);
    const long tasks = arguments_.tasks > 0
                           ? arguments_.tasks
                           : choose_task_count(static_cast<long>(cases.size()), submission.options);
    SlurmScript& script = submission.script;
    script.name = make_job_name();
    script.program = fs::read_symlink("/proc/self/exe");
    script.directory = fs::current_path();
    script.files = arguments_.files;
    script.folder = make_absolute(folder_);
    script.slices = divide_cases(cases, holders.taken, tasks);
    script.retry_failed = !failed.empty();
    submission.file = fmt::format("{}-{}.sbatch", script.name, jobs_.size() + 1);
    return submission;
}

std::string SlurmBatch::make_job_name() const {
    const fs::path plan = batch_.plan().file;
    return gxrod::make_job_name((plan.empty() ? make_absolute(folder_).filename() : plan.stem()).string());
}

std::string SlurmBatch::gather_command() const {
    std::string command = "gxrod batch";
    for (const std::string& file : arguments_.files) command += " " + quote_for_shell(file);
    if (arguments_.has_folder) command += " -o " + quote_for_shell(folder_.string());
    return command + " --gather";
}

}  // namespace

ExitCode submit_batch(const PreparedBatch& batch, const SlurmArguments& arguments) {
    return SlurmBatch(batch, arguments).submit();
}

ExitCode gather_batch(const PreparedBatch& batch, const SlurmArguments& arguments) {
    return SlurmBatch(batch, arguments).gather();
}

}  // namespace gxrod
