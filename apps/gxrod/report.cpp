#include "report/report.hpp"

#include <fmt/core.h>

#include <memory>

#include "exit_code.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

struct ReportArguments {
    std::string results;
    std::string page;
    double budget = 20.0;
    bool force = false;
};

int report(const ReportArguments& arguments) {
    constexpr double megabyte = 1e6;
    ReportOptions options;
    options.results = arguments.results;
    options.page = arguments.page;
    if (arguments.page.empty()) options.page = options.results.filename().replace_extension(".html");
    options.most_bytes = static_cast<std::size_t>(arguments.budget * megabyte);
    if (arguments.force) options.existing = Existing::replace;
    const ReportSummary summary = write_report(options);
    for (const std::string& warning : summary.warnings) fmt::print(stderr, "warning: {}\n", warning);
    for (const std::string& sentence : summary.left_out) fmt::print("{}\n", sentence);
    fmt::print("{} ({:.1f} MB)\n", options.page.string(), static_cast<double>(summary.bytes) / megabyte);
    return exit_done;
}

}  // namespace

void add_report_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<ReportArguments>();
    CLI::App* verb = program.add_subcommand(
        "report", "Write one HTML page that shows results: motion in 3D, charts, deck, model");
    verb->add_option("RESULTS", arguments->results, "Results file of gxrod run; that of a running job too")
        ->required();
    verb->add_option(
        "-o,--output", arguments->page, "Page to write [the results' name with .html, in this folder]");
    verb->add_option(
            "--budget", arguments->budget, "Largest size of the page in MB; data are thinned to it [20]")
        ->check(CLI::Range(1.0, 2000.0));
    verb->add_flag("--force", arguments->force, "Overwrite an existing page");
    verb->footer(
        "The page is one file, needs no network and opens with a double click. It says what was left out.");
    verb->callback([arguments, &exit_code] { exit_code = report(*arguments); });
}

}  // namespace gxrod
