#include "job.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <new>

#include "batch/plan/plan.hpp"
#include "check/model_examination.hpp"
#include "check/shape_report.hpp"
#include "deck/schema/suggestion.hpp"
#include "exit_code.hpp"
#include "machine/file_error.hpp"
#include "model/settings/scheme_card.hpp"
#include "parallel/cores.hpp"
#include "progress_line.hpp"
#include "results/export/line_end_table.hpp"
#include "results/results_size.hpp"
#include "say.hpp"
#include "summary.hpp"

namespace gxrod {

namespace {

volatile std::sig_atomic_t interrupt_signal = 0;

// The first signal asks the run to end after the current step; the second ends it at once.
extern "C" void ask_to_end(int signal) {
    interrupt_signal = signal;
    std::signal(signal, SIG_DFL);
}

void print_shapes(const FoundShapes& found) {
    constexpr std::size_t most = 20;
    const std::vector<std::string> lines = list_shapes(found.record, most);
    say(stdout, "{}: {}\n", found.stage, lines.front());
    for (std::size_t i = 1; i < lines.size(); ++i) say(stdout, "  {}\n", lines[i]);
}

void print_found(const RunSummary& summary) {
    for (const std::string& finding : summary.findings) say(stdout, "{}\n", finding);
    for (const FoundShapes& found : summary.shapes) print_shapes(found);
}

// "mooring lies on the ground up to s = 124.2 to 162, at rest 144.5".
std::string describe_touch_down(const LineEndRow& row) {
    return fmt::format("{} lies on the ground {} s = {:.6g} to {:.6g}{}\n",
                       row.point,
                       row.quantity.ends_with("end") ? "up to" : "from",
                       row.range.least,
                       row.range.largest,
                       std::isnan(row.at_rest) ? "" : fmt::format(", at rest {:.6g}", row.at_rest));
}

// Where lines on a ground have touched it, of decks with output.line_ends.
void print_touch_downs(const std::string& results) {
    std::vector<std::string> lines;
    try {
        for (const LineEndRow& row : read_line_ends(results, {})) {
            const bool is_free = std::isnan(row.range.least) || row.range.largest == 0.0;
            if (row.quantity.starts_with("touch_down") && !is_free) lines.push_back(describe_touch_down(row));
        }
    } catch (const FileError&) {
        return;  // the run itself is over and well
    }
    lines.erase(std::ranges::unique(lines).begin(), lines.end());
    for (const std::string& line : lines) say_text(stdout, line);
}

void print(const JobOptions& options, const RunSummary& summary, bool is_resumed) {
    if (summary.status == RunStatus::failed) {
        say(stderr,
            "gxrod: {}\nResults up to {} are in {}\n",
            summary.reason,
            summary.place,
            options.results);
    } else if (summary.stopped_as_asked) {
        if (options.prints()) {
            print_found(summary);
            say(stdout,
                "stopped after stage {} at {}, {:.2f} s\nResults: {}\nTo resume: gxrod resume {}\n",
                options.until,
                summary.place,
                summary.wall_seconds,
                options.results,
                options.results);
        }
    } else if (summary.status == RunStatus::interrupted) {
        say(stderr,
            "gxrod: interrupted at {}; results up to there are in {}\n"
            "To resume: gxrod resume {}\n",
            summary.place,
            options.results,
            options.results);
    } else if (options.prints()) {
        print_found(summary);
        if (summary.totals.steps > 0) {
            say(stdout,
                "{} steps to {}, {} Newton iterations{}, ",
                summary.totals.steps,
                summary.place,
                summary.totals.newton_iterations,
                is_resumed ? " in all; this part" : "");
        }
        say(stdout, "{:.2f} s\nResults: {}\n", summary.wall_seconds, options.results);
    }
}

int exit_code_of(const RunSummary& summary, bool deck_fault) {
    if (summary.stopped_as_asked) return exit_done;
    if (summary.status == RunStatus::interrupted) return exit_interrupted;
    if (summary.out_of_memory) return exit_internal_error;
    if (summary.status == RunStatus::failed) return deck_fault ? exit_bad_input : exit_not_converged;
    return exit_done;
}

std::string describe_place(const RestartRecord& record) {
    if (record.path.load_scale > 0.0) return fmt::format("λ = {:.10g}", record.path.load_factor);
    return fmt::format("t = {:.10g}", record.axis_start + record.steps.time);
}

// After an error that ended the program while it wrote: how to resume, if that is possible.
void print_resumption(const std::string& results) {
    try {
        say(stderr,
            "{} holds what was computed up to {}. To resume: gxrod resume {}\n",
            results,
            describe_place(ResumableFile(results).place().record),
            results);
    } catch (const std::exception&) {
        // Nothing to resume from, or no memory to look.
    }
}

void note_threads(const JobOptions& options) {
    if (options.quiet || options.threads <= count_cores()) return;
    say(stderr,
        "note: --threads {}: with {} core{} they slow each other down\n",
        options.threads,
        count_cores(),
        count_cores() == 1 ? "" : "s");
}

// Reports what is suspicious, before the run.
void print(const JobOptions& options, const std::vector<Finding>& findings) {
    for (const Finding& finding : findings) {
        if (finding.severity != Severity::note) say(stderr, "{}: {}\n", options.deck, describe(finding));
    }
}

void say_chosen_schemes(const JobOptions& options, const Problem& problem) {
    if (!options.prints()) return;
    for (const StagePlan& stage : problem.stages) {
        const auto* dynamic = std::get_if<DynamicSettings>(&stage.analysis);
        if (dynamic == nullptr || dynamic->chosen_for.empty()) continue;
        say(stdout,
            "{}integrator auto takes {}: {}\n",
            stage.name.empty() ? "" : "stage " + stage.name + ": ",
            card_of(dynamic->scheme).word,
            dynamic->chosen_for);
    }
    std::fflush(stdout);
}

// Throws FileError if the disk is too small for what the run would write.
void check_room(const JobOptions& options, const Problem& problem) {
    constexpr double gigabyte = 1e9;
    const ResultsSize size = estimate_results_size(problem.model, problem.stages, problem.output);
    const std::filesystem::path folder = std::filesystem::path(options.results).parent_path();
    std::error_code error;
    const std::filesystem::space_info room = std::filesystem::space(folder.empty() ? "." : folder, error);
    if (error || size.bytes <= static_cast<double>(room.available)) return;
    throw FileError(
        options.results,
        fmt::format("would take more than {:.3g} GB, for {}{:.6g} frames, where {:.3g} GB are free",
                    size.bytes / gigabyte,
                    size.steps > 0.0 ? fmt::format("{:.6g} steps and ", size.steps) : "",
                    size.frames,
                    static_cast<double>(room.available) / gigabyte),
        "a larger output.every or output.interval makes fewer frames; histories have each step");
}

// Throws DeckError if the run is to stop after a stage that the deck does not have.
void check_until(const Problem& problem, const JobOptions& options) {
    if (options.until.empty()) return;
    std::vector<std::string> names;
    for (const StagePlan& stage : problem.stages) {
        if (!stage.name.empty()) names.push_back(stage.name);
    }
    if (std::ranges::find(names, options.until) != names.end()) return;
    const std::string known =
        names.empty() ? "; the deck has no [[stage]]" : "; the deck has " + plain_list(names);
    const std::string hint = did_you_mean(options.until, names);
    throw DeckError(
        {{options.deck,
          0,
          0,
          "",
          fmt::format("--until {}: no such stage{}", options.until, hint.empty() ? known : hint)}});
}

// Runs and reports the outcome.
int run_and_tell(const RunRequest& request, const JobOptions& options, ProgressLine& line) {
    const RunSummary summary = run_analysis(request);
    line.finish();
    print(options, summary, request.resumed != nullptr);
    const bool records_ends = std::ranges::any_of(
        request.problem.output.histories,
        [](const HistoryRequest& one) { return std::holds_alternative<WatchedContacts>(one.target); });
    if (records_ends && options.prints() && summary.status == RunStatus::complete)
        print_touch_downs(options.results);
    if (!options.quiet) {
        for (const std::string& note : summary.notes) say(stderr, "note: {}\n", note);
    }
    for (const std::string& warning : summary.warnings) {
        const bool is_printed =
            std::ranges::find(request.examined, warning, &Finding::message) != request.examined.end();
        if (!is_printed) say(stderr, "warning: {}\n", warning);
    }
    if (!options.summary.empty()) write_summary(options.summary, summary, options.deck, options.results);
    return exit_code_of(summary, summary.deck_fault);
}

}  // namespace

void add_job_options(CLI::App& verb, JobOptions& options) {
    constexpr int most_threads = 1024;
    verb.add_option("--threads",
                    options.threads,
                    "Threads that share the work of one run; results are the same for any number [1]")
        ->check(CLI::Range(1, most_threads));
    verb.add_option(
        "--summary", options.summary, "Write a summary of the run as JSON to a file, or - for stdout");
    verb.add_option(
        "--until", options.until, "Name of the stage after which the run stops; gxrod resume continues it");
    verb.add_flag("--quiet", options.quiet, "Print only warnings and errors");
}

Problem read_job_problem(const std::string& deck, const std::vector<std::string>& overrides) {
    try {
        return read_problem(deck, overrides);
    } catch (const DeckError& error) {
        std::error_code ignored;
        const bool can_be_read_again = std::filesystem::is_regular_file(deck, ignored);
        if (error.faults.front().line == 0 || !can_be_read_again || !is_plan(deck)) throw;
        throw DeckError({{deck, 0, 0, "", "is the plan of a batch, not a deck; gxrod batch runs it"}});
    }
}

int run_job(const Problem& problem, const JobOptions& options, ResumableFile* resumed) {
    check_until(problem, options);
    const std::vector<Finding> findings = examine_stages(problem.model, problem.stages);
    print(options, findings);
    if (has_error(findings)) return exit_bad_input;
    if (resumed == nullptr) check_room(options, problem);
    note_threads(options);
    say_chosen_schemes(options, problem);
    std::signal(SIGINT, ask_to_end);
    std::signal(SIGTERM, ask_to_end);
    ProgressLine line;
    RunRequest request{problem, ResultsFileOptions{options.results, options.existing}, resumed};
    if (!options.quiet) request.report_progress = [&](const Progress& progress) { line.show(progress); };
    if (options.prints()) {
        request.report_resumption = [&](const RestartRecord& record) {
            say(stdout, "{} continues from {}\n", options.results, describe_place(record));
            std::fflush(stdout);
        };
    }
    request.examined = findings;
    request.is_interrupted = [] { return interrupt_signal != 0; };
    request.threads = options.threads;
    request.until = options.until;
    try {
        return run_and_tell(request, options, line);
    } catch (const WriteError& error) {
        line.finish();
        say(stderr, "gxrod: {}\n", error.what());
        print_resumption(options.results);
        return exit_file;
    } catch (const std::bad_alloc&) {
        line.finish();
        say_text(stderr, out_of_memory);
        print_resumption(options.results);
        return exit_internal_error;
    }
}

}  // namespace gxrod
