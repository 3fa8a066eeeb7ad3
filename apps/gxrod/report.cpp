#include "report/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include "exit_code.hpp"
#include "machine/printable.hpp"
#include "progress_line.hpp"
#include "report/batch_report.hpp"
#include "say.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

constexpr double megabyte = 1e6;

struct ReportArguments {
    std::string results;
    std::string page;
    std::string cases;
    double budget = 20.0;
    bool force = false;

    std::size_t most_bytes() const { return static_cast<std::size_t>(budget * megabyte); }
    Existing existing() const { return force ? Existing::replace : Existing::refuse; }
};

void print_page(const std::filesystem::path& page, std::size_t bytes) {
    say(stdout, "{} ({:.1f} MB)\n", page.string(), static_cast<double>(bytes) / megabyte);
}

int report_run(const ReportArguments& arguments) {
    if (!arguments.cases.empty()) {
        throw CLI::ValidationError("--cases is for the folder of a batch, and " + arguments.results +
                                   " is not one");
    }
    ReportOptions options;
    options.results = arguments.results;
    options.page = arguments.page;
    if (arguments.page.empty()) options.page = options.results.filename().replace_extension(".html");
    options.most_bytes = arguments.most_bytes();
    options.existing = arguments.existing();
    const ReportSummary summary = write_report(options);
    for (const std::string& warning : summary.warnings) say(stderr, "warning: {}\n", printable(warning));
    for (const std::string& sentence : summary.left_out) say(stdout, "{}\n", printable(sentence));
    print_page(options.page, summary.bytes);
    return exit_done;
}

std::optional<long> read_count(std::string_view text) {
    long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 1) return std::nullopt;
    return number;
}

// "", "all", "none", "I..J" or "I".
CaseChoice read_choice(const std::string& text) {
    CaseChoice choice;
    if (text.empty()) return choice;
    choice.most = text == "none" ? 0 : std::numeric_limits<std::size_t>::max();
    if (text == "all" || text == "none") return choice;
    const std::size_t dots = text.find("..");
    const std::optional<long> first = read_count(std::string_view(text).substr(0, dots));
    const std::optional<long> last =
        dots == std::string::npos ? first : read_count(std::string_view(text).substr(dots + 2));
    if (!first || !last || *first > *last) {
        throw CLI::ValidationError("--cases " + text +
                                   ": expected all, none, or numbers such as 17 or 1..40");
    }
    choice.range = {*first, *last};
    return choice;
}

void print_case_pages(const CasePages& pages, bool is_chosen) {
    constexpr std::size_t most_faults = 5;
    for (std::size_t i = 0; i < std::min(pages.faults.size(), most_faults); ++i) {
        say(stderr, "warning: no page of a case: {}\n", printable(pages.faults[i]));
    }
    if (pages.faults.size() > most_faults) {
        say(stderr, "warning: {} more cases have no page\n", pages.faults.size() - most_faults);
    }
    if (pages.lost > 0) {
        say(stderr,
            "warning: results of {} {} are in the table, but not in the folder\n",
            pages.lost,
            pages.lost == 1 ? "case" : "cases");
    }
    if (pages.passed_over > 0 && !is_chosen) {
        say(stdout,
            "{} of the cases with results have no page; failed cases came first (--cases all makes all "
            "pages, "
            "--cases I..J some)\n",
            pages.passed_over);
    }
    if (pages.written + pages.kept > 0) {
        say(stdout, "pages of cases: {} written, {} kept as they were\n", pages.written, pages.kept);
    }
}

int report_batch(const ReportArguments& arguments) {
    ProgressLine progress_line;
    BatchReportOptions options;
    options.folder = arguments.results;
    options.page =
        arguments.page.empty() ? options.folder / "report.html" : std::filesystem::path(arguments.page);
    options.most_bytes = arguments.most_bytes();
    options.existing = arguments.existing();
    options.cases = read_choice(arguments.cases);
    options.progress = [&](std::size_t written, std::size_t all) {
        progress_line.show([&] { return fmt::format("{} of {} pages of cases", written, all); });
    };
    const BatchReportSummary summary = write_batch_report(options);
    progress_line.finish();
    print_case_pages(summary.pages, !arguments.cases.empty());
    if (summary.finished < static_cast<std::size_t>(summary.cases)) {
        say(stdout, "{} of {} cases have ended\n", summary.finished, summary.cases);
    }
    for (const std::string& sentence : summary.left_out) say(stdout, "{}\n", printable(sentence));
    print_page(options.page, summary.bytes);
    return exit_done;
}

}  // namespace

void add_report_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<ReportArguments>();
    CLI::App* verb = program.add_subcommand(
        "report", "Write one HTML page that shows results: motion in 3D, charts, deck, model; or a batch");
    verb->add_option("RESULTS",
                     arguments->results,
                     "Results file of gxrod run, also of a running job; or the folder of a batch")
        ->required();
    verb->add_option(
        "-o,--output",
        arguments->page,
        "Page to write [the results' name with .html, in this folder; of a batch report.html in its own]");
    verb->add_option(
            "--budget", arguments->budget, "Largest size of the page in MB; data are thinned to it [20]")
        ->check(CLI::Range(1.0, 2000.0));
    verb->add_option("--cases",
                     arguments->cases,
                     "Of a batch: cases that get a page of their own: all, none, or I..J "
                     "[200, those that "
                     "failed first]");
    verb->add_flag("--force", arguments->force, "Overwrite an existing page");
    verb->footer(
        "The page is one file, needs no network and opens with a double click. It says what was left out. "
        "That of a\n"
        "batch links to pages of its cases in the batch's folder reports/, 3 MB each at most; those that are "
        "newer\n"
        "than their results stay as they are.");
    verb->callback([arguments, &exit_code] {
        const bool is_folder = std::filesystem::is_directory(arguments->results);
        exit_code = is_folder ? report_batch(*arguments) : report_run(*arguments);
    });
}

}  // namespace gxrod
