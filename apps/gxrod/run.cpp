#include <filesystem>
#include <memory>

#include "deck/problem.hpp"
#include "job.hpp"
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

std::filesystem::path results_path(const RunArguments& arguments) {
    if (!arguments.results.empty()) return arguments.results;
    return std::filesystem::path(arguments.deck).filename().replace_extension(".vtkhdf");
}

int run(const RunArguments& arguments) {
    const Problem problem = read_problem(arguments.deck, arguments.overrides);
    return run_job(problem,
                   {arguments.deck,
                    results_path(arguments).string(),
                    arguments.summary,
                    arguments.quiet,
                    arguments.force ? Existing::replace : Existing::refuse});
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
