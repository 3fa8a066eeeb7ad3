#include "batch/batch.hpp"
#include "batch/members/member_forces.hpp"

#include <fmt/core.h>

#include <charconv>
#include <csignal>
#include <memory>

#include "batch_output.hpp"
#include "batch_slurm.hpp"
#include "exit_code.hpp"
#include "machine/file_error.hpp"
#include "parallel/cores.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

struct BatchArguments {
    std::vector<std::string> files;
    std::string folder;
    std::string only;
    std::string summary;
    int workers = 0;
    bool retry_failed = false;
    bool dry_run = false;
    bool force = false;
    bool quiet = false;
    bool slurm = false;
    bool gather = false;
    long tasks = 0;
    std::optional<std::vector<std::string>> sbatch_options;

    bool prints() const { return !quiet && summary != "-"; }
};

volatile std::sig_atomic_t signals = 0;

// Ctrl-C asks to end after the running cases, again at once; SIGTERM, as from a cluster, at once.
extern "C" void ask_batch_to_end(int signal) { signals = signal == SIGTERM ? 2 : signals + 1; }

Interruption read_interruption() {
    if (signals == 0) return Interruption::none;
    return signals == 1 ? Interruption::finish_cases : Interruption::stop;
}

void listen_to_signals() {
    struct sigaction action {};
    action.sa_handler = ask_batch_to_end;  // without SA_RESTART: waiting ends
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);  // its output need not be read
    std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes is an error of writing
}

Plan read_arguments(const std::vector<std::string>& files) {
    if (files.size() == 1) {
        // Read once, as it can be a pipe.
        std::string text = read_plan_file(files[0]);
        if (is_plan_text(text, files[0])) return read_plan_text(std::move(text), files[0]);
        if (std::optional<Plan> combinations = plan_of_combinations(text, files[0])) return *combinations;
    }
    for (const std::string& file : files) {
        if (files.size() > 1 && is_plan(file)) {
            throw CLI::ValidationError(file + " is a plan; expected one plan, or decks only");
        }
    }
    return plan_of_decks({files.begin(), files.end()});
}

std::filesystem::path default_folder(const Plan& plan) {
    return plan.file.empty() ? "batch" : std::filesystem::path(plan.file).stem();
}

CaseRange read_range(const std::string& text, long cases) {
    CaseRange range{0, 0};
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, range.first);
    const bool has_dots = std::string_view(first.ptr, end).starts_with("..");
    const auto last = std::from_chars(has_dots ? first.ptr + 2 : end, end, range.last);
    if (!has_dots) range.last = range.first;  // one case
    const bool is_read =
        first.ec == std::errc() && (has_dots ? last.ec == std::errc() && last.ptr == end : first.ptr == end);
    if (!is_read || range.first < 1 || range.last < range.first || range.last > cases) {
        throw CLI::ValidationError(fmt::format(
            "--only {}: expected I..J, the first and the last case to run, from 1 to {}", text, cases));
    }
    return range;
}

int exit_code_of(const BatchSummary& summary) {
    if (summary.is_interrupted) return exit_interrupted;
    return summary.is_complete() ? exit_done : exit_not_converged;
}

int batch_on_cluster(const PreparedBatch& batch,
                     const BatchArguments& arguments,
                     const std::filesystem::path& folder) {
    const SlurmArguments cluster{.files = arguments.files,
                                 .folder = folder,
                                 .has_folder = !arguments.folder.empty(),
                                 .options = arguments.sbatch_options,
                                 .tasks = arguments.tasks,
                                 .retry_failed = arguments.retry_failed,
                                 .dry_run = arguments.dry_run,
                                 .begin_anew = arguments.force,
                                 .quiet = arguments.quiet};
    return arguments.slurm ? submit_batch(batch, cluster) : gather_batch(batch, cluster);
}

int batch(const BatchArguments& arguments) {
    const bool is_on_cluster = arguments.slurm || arguments.gather;
    if (!is_on_cluster && (arguments.sbatch_options || arguments.tasks > 0)) {
        throw CLI::ValidationError(
            fmt::format("{} is for jobs of a cluster; expected --slurm or --gather too",
                        arguments.tasks > 0 ? "--tasks" : "the part after --"));
    }
    BatchOutput output(arguments.quiet, arguments.prints());
    Plan plan = read_arguments(arguments.files);
    std::optional<CaseRange> only;
    if (!arguments.only.empty()) only = read_range(arguments.only, CaseList(plan).count());
    const PreparedBatch prepared(
        std::move(plan), only, [&](long examined, long cases) { output.show_examined(examined, cases); });
    output.finish_line();
    BatchRequest request;
    request.folder =
        arguments.folder.empty() ? default_folder(prepared.plan()) : std::filesystem::path(arguments.folder);
    if (is_on_cluster) return batch_on_cluster(prepared, arguments, request.folder);
    request.only = only;
    request.workers = arguments.workers > 0 ? arguments.workers : count_cores();
    request.retry_failed = arguments.retry_failed;
    request.begin_anew = arguments.force;
    if (arguments.dry_run) {
        output.show_plan(prepared, request);
        return exit_done;
    }
    output.show_size(prepared, request);
    listen_to_signals();
    request.interruption = read_interruption;
    request.report_progress = [&](const BatchProgress& progress) {
        output.show_progress(progress, signals == 1);
    };
    request.report_failure = [&](const CaseRow& row) { output.show_failure(row, prepared.cases()); };
    const BatchSummary summary = run_batch(prepared, request);
    output.finish_line();
    output.show_summary(summary, request);
    if (varies_combinations(prepared.plan()))
        output.show_members(write_member_tables(request.folder, prepared.cases(), summary.rows), request);
    if (!arguments.summary.empty()) write_batch_summary(arguments.summary, summary, request);
    return exit_code_of(summary);
}

}  // namespace

void add_batch_verb(CLI::App& program,
                    int& exit_code,
                    std::optional<std::vector<std::string>> sbatch_options) {
    auto arguments = std::make_shared<BatchArguments>();
    arguments->sbatch_options = std::move(sbatch_options);
    CLI::App* verb =
        program.add_subcommand("batch", "Run many variants of a deck on all cores; one table of them all");
    verb->add_option("FILES",
                     arguments->files,
                     "A plan (TOML; docs/plan.md lists its keys), a deck with [combination.NAME]s, or decks")
        ->required();
    verb->add_option(
        "-o,--output", arguments->folder, "Folder of the batch [the plan's name, in this folder]");
    verb->add_option("-j,--jobs", arguments->workers, "Cases that run at once [the cores]")
        ->check(CLI::Range(1, 4096));
    CLI::Option* only = verb->add_option(
        "--only", arguments->only, "I..J: only these cases; several such runs can share a folder");
    verb->add_flag("--retry-failed", arguments->retry_failed, "Also run again the cases that are not done");
    verb->add_flag("--dry-run", arguments->dry_run, "Read and examine all cases, list them, and run none");
    verb->add_flag("--force", arguments->force, "Discard what the folder holds, even another batch")
        ->excludes(only);
    verb->add_option("--summary", arguments->summary, "Write a summary as JSON to a file, or - for stdout");
    verb->add_flag("--quiet", arguments->quiet, "Print only warnings and errors");
    auto* slurm =
        verb->add_flag("--slurm", arguments->slurm, "Submit an array job to Slurm that runs the cases");
    auto* gather = verb->add_flag(
        "--gather", arguments->gather, "Complete the table; submit again what jobs left missing or failed");
    verb->add_option("--tasks", arguments->tasks, "Tasks of the array job [four cases a core, 100 at most]")
        ->check(CLI::Range(1, 1'000'000));
    slurm->excludes(gather);
    for (const char* name : {"--only", "--jobs", "--summary"}) {
        slurm->excludes(verb->get_option(name));
        gather->excludes(verb->get_option(name));
    }
    gather->excludes(verb->get_option("--force"));
    verb->footer(
        "Everything after -- is an option of sbatch: gxrod batch PLAN --slurm -- -c 8 --time 2:00:00\n"
        "The same command resumes a batch that was stopped or killed: it runs what the table lacks.\n"
        "Exit codes: 0 if every case is done, 3 if not, 130 if interrupted.");
    verb->callback([arguments, &exit_code] { exit_code = batch(*arguments); });
}

}  // namespace gxrod
