#include "batch_slurm_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "batch_output.hpp"
#include "say.hpp"

namespace gxrod {

namespace {

// "2 PENDING (Resources), 1 RUNNING"
std::string count_states(const std::vector<SlurmTask>& tasks, const std::string& job) {
    std::map<std::string, int> counts;
    for (const SlurmTask& task : tasks) {
        if (task.job != job) continue;
        const bool has_reason = !task.reason.empty() && task.reason != "None";
        ++counts[has_reason ? fmt::format("{} ({})", task.state, task.reason) : task.state];
    }
    std::string text;
    for (const auto& [state, count] : counts)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, state);
    return text;
}

}  // namespace

void print_holders(const CaseHolders& holders, long taken) {
    std::vector<std::string> jobs;
    for (const SlurmTask& task : holders.tasks) {
        if (std::find(jobs.begin(), jobs.end(), task.job) == jobs.end()) jobs.push_back(task.job);
    }
    for (const std::string& job : jobs)
        say(stdout, "Tasks of job {}: {}\n", job, count_states(holders.tasks, job));
    if (taken == 0) return;
    say(stdout,
        "{} not done yet, left to {}\n",
        count_cases(static_cast<std::size_t>(taken)),
        jobs.empty() ? "another gxrod batch that runs" : "what is queued or running");
}

void print_script(const Submission& submission) {
    std::string command = "sbatch --parsable";
    for (const std::string& option : submission.options) command += " " + quote_for_shell(option);
    const std::filesystem::path file = slurm_folder(submission.script.folder) / submission.file;
    say(stdout,
        "{}\n# {} {}\n",
        write_slurm_script(submission.script),
        command,
        quote_for_shell(file.string()));
}

void print_job(const SlurmJob& job,
               const Submission& submission,
               std::size_t cases,
               const std::string& gather_command) {
    const std::filesystem::path folder = slurm_folder(submission.script.folder);
    const std::size_t tasks = job.slices.size();
    say(stdout,
        "Submitted as job {}: {} in {} task{}\n",
        job.id,
        count_cases(cases),
        tasks,
        tasks == 1 ? "" : "s");
    say(stdout,
        "Script: {}\nOutput: {}\n",
        (folder / submission.file).string(),
        (folder / (job.id + "_*.out")).string());
    say(stdout,
        "Queue: squeue{} -j {}\nTable, now or when the job has ended: {}\n",
        job.cluster.empty() ? "" : " -M " + job.cluster,
        job.id,
        gather_command);
}

void print_table(const std::filesystem::path& folder, const std::vector<CaseRow>& rows, long cases) {
    const long done = std::count_if(
        rows.begin(), rows.end(), [](const CaseRow& row) { return row.status == CaseStatus::done; });
    const long failed = static_cast<long>(rows.size()) - done;
    const long missing = cases - static_cast<long>(rows.size());
    print_failures(group_failures(rows));
    say(stdout,
        "{} of {} done{}{}\nTable: {}\n",
        done,
        count_cases(static_cast<std::size_t>(cases)),
        failed > 0 ? fmt::format(", {} not", failed) : "",
        missing > 0 ? fmt::format(", {} missing", missing) : "",
        table_path(folder).string());
}

}  // namespace gxrod
