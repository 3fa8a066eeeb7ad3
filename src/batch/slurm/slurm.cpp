#include "batch/slurm/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "batch/program_output.hpp"

namespace gxrod {
namespace {

constexpr const char* missing_hint = "Slurm's commands are expected on this machine";

// Its messages, in one line.
std::string join_lines(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

std::string describe_fault(const ProgramOutput& done) {
    const std::string said = join_lines(done.errors.empty() ? done.output : done.errors);
    return fmt::format("exit code {}{}", done.exit_code, said.empty() ? "" : ", " + said);
}

std::vector<SlurmTask> ask_cluster(const std::string& cluster, const std::vector<SlurmJob>& jobs) {
    std::string ids;
    for (const SlurmJob& job : jobs) {
        if (job.cluster == cluster) ids += (ids.empty() ? "" : ",") + job.id;
    }
    std::vector<std::string> words{"squeue", "-h", "-r", "-j", ids, "-o", squeue_format};
    if (!cluster.empty()) words.insert(words.end(), {"-M", cluster});
    const ProgramOutput done = run_program(words);
    if (!done.was_found) throw SlurmError("squeue", "there is no such command", missing_hint);
    // What it says of a single job that ended some minutes ago.
    if (done.errors.find("Invalid job id specified") != std::string::npos) return {};
    if (done.exit_code != 0)
        throw SlurmError("squeue",
                         fmt::format("does not say what became of job {}: {}", ids, describe_fault(done)));
    return read_squeue(done.output, jobs);
}

}  // namespace

bool has_slurm() { return run_program({"sbatch", "--version"}).was_found; }

SlurmJob submit_to_slurm(const std::filesystem::path& script, const std::vector<std::string>& options) {
    std::vector<std::string> words{"sbatch", "--parsable"};
    words.insert(words.end(), options.begin(), options.end());
    words.push_back(script.string());
    const ProgramOutput done = run_program(words);
    if (!done.was_found) throw SlurmError("sbatch", "there is no such command", missing_hint);
    if (done.exit_code != 0) {
        throw SlurmError("sbatch",
                         "refused the job: " + describe_fault(done),
                         "nothing was submitted; everything after -- is an option of sbatch");
    }
    SlurmJob job = read_submission(done.output);
    if (job.id.empty())
        throw SlurmError("sbatch", "did not print a job number, but: " + join_lines(done.output));
    return job;
}

std::vector<SlurmTask> ask_slurm(const std::vector<SlurmJob>& jobs) {
    std::set<std::string> clusters;
    for (const SlurmJob& job : jobs) clusters.insert(job.cluster);
    std::vector<SlurmTask> tasks;
    for (const std::string& cluster : clusters) {
        const std::vector<SlurmTask> found = ask_cluster(cluster, jobs);
        tasks.insert(tasks.end(), found.begin(), found.end());
    }
    return tasks;
}

}  // namespace gxrod
