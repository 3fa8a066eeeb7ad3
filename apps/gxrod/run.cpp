#include "analyses/run.hpp"

#include <fmt/core.h>

#include <atomic>
#include <csignal>
#include <filesystem>

#include "analyses/model_examination.hpp"
#include "deck/problem.hpp"
#include "exit_code.hpp"
#include "progress_line.hpp"
#include "summary.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

struct RunArguments {
    std::string deck;
    std::string results;
    std::vector<std::string> overrides;
    std::string summary;
    int threads = 1;
    bool quiet = false;
    bool force = false;
};

volatile std::sig_atomic_t interrupt_signal = 0;

// The first signal asks the run to end after the step at hand; the second ends it at once.
extern "C" void ask_to_end(int signal) {
    interrupt_signal = signal;
    std::signal(signal, SIG_DFL);
}

std::filesystem::path results_path(const RunArguments& arguments) {
    if (!arguments.results.empty()) return arguments.results;
    return std::filesystem::path(arguments.deck).filename().replace_extension(".vtkhdf");
}

void tell(const RunArguments& arguments, const RunSummary& summary, const std::string& results) {
    if (summary.status == RunStatus::failed) {
        fmt::print(stderr,
                   "gxrod: {}\nResults up to t = {:.10g} are in {}\n",
                   summary.reason,
                   summary.time,
                   results);
    } else if (summary.status == RunStatus::interrupted) {
        fmt::print(stderr,
                   "gxrod: interrupted at t = {:.10g}; results up to there are in {}\n",
                   summary.time,
                   results);
    } else if (!arguments.quiet && arguments.summary != "-") {
        fmt::print("{} steps to t = {:.10g}, {} Newton iterations, {:.2f} s\nResults: {}\n",
                   summary.steps,
                   summary.time,
                   summary.newton_iterations,
                   summary.wall_seconds,
                   results);
    }
}

// Energy out of balance by so much of the largest one says that results are not to be trusted.
void warn_of_energy(const RunSummary& summary) {
    constexpr double tolerable = 0.1;
    if (summary.largest_energy_error <= tolerable * summary.largest_energy) return;
    fmt::print(
        stderr,
        "warning: the energy does not balance: an error of {:.3g} beside an energy of {:.3g} "
        "(ledger/energy_error). Steps may be too long, a vibration too fast for them, or, in statics, the "
        "structure has jumped\n",
        summary.largest_energy_error,
        summary.largest_energy);
}

int exit_code_of(const RunSummary& summary, bool deck_fault) {
    if (summary.status == RunStatus::interrupted) return exit_interrupted;
    if (summary.status == RunStatus::failed) return deck_fault ? exit_bad_input : exit_not_converged;
    return exit_done;
}

// Tells of what is suspicious; whether the model can be run.
bool examine(const RunArguments& arguments, const Problem& problem) {
    const std::vector<Finding> findings = examine_model(problem.model, problem.analysis);
    for (const Finding& finding : findings) {
        const bool is_told = finding.severity == Severity::error ||
                             (finding.severity == Severity::warning && !arguments.quiet);
        if (is_told) fmt::print(stderr, "{}: {}\n", arguments.deck, describe(finding));
    }
    return !has_error(findings);
}

int run(const RunArguments& arguments) {
    const Problem problem = read_problem(arguments.deck, arguments.overrides);
    if (!examine(arguments, problem)) return exit_bad_input;
    const std::filesystem::path results = results_path(arguments);
    std::signal(SIGINT, ask_to_end);
    std::signal(SIGTERM, ask_to_end);
    ProgressLine line;
    RunRequest request{problem.model,
                       problem.analysis,
                       problem.output,
                       problem.record,
                       {results, arguments.force ? Existing::replace : Existing::refuse}};
    if (!arguments.quiet) request.report_progress = [&](const Progress& progress) { line.show(progress); };
    request.is_interrupted = [] { return interrupt_signal != 0; };
    const RunSummary summary = run_analysis(request);
    line.finish();
    tell(arguments, summary, results.string());
    warn_of_energy(summary);
    if (!arguments.summary.empty()) {
        write_summary(arguments.summary, summary, arguments.deck, results.string());
    }
    return exit_code_of(summary, summary.deck_fault);
}

}  // namespace

void add_run_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<RunArguments>();
    CLI::App* verb = program.add_subcommand("run", "Run a deck and write its results");
    verb->add_option("DECK", arguments->deck, "Deck (TOML); docs/deck.md lists its keys")->required();
    verb->add_option(
        "-o,--output", arguments->results, "Results file [the deck's name with .vtkhdf, in this folder]");
    verb->add_option(
            "--set", arguments->overrides, "KEY=VALUE: change a key of the deck, say analysis.time_step=0.01")
        ->allow_extra_args(false);
    verb->add_option("--threads", arguments->threads, "Threads; this version runs on one")
        ->check(CLI::Range(1, 1));
    verb->add_option(
        "--summary", arguments->summary, "Write a summary of the run as JSON to a file, or - for stdout");
    verb->add_flag("--quiet", arguments->quiet, "Say nothing unless something is wrong");
    verb->add_flag("--force", arguments->force, "Overwrite an existing results file");
    verb->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace gxrod
