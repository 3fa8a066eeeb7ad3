#include <filesystem>
#include <memory>

#include "deck/problem.hpp"
#include "job.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

struct RunArguments {
    JobOptions job;
    std::vector<std::string> overrides;
    bool force = false;
};

std::string results_path(const std::string& deck) {
    return std::filesystem::path(deck).filename().replace_extension(".vtkhdf").string();
}

int run(RunArguments& arguments) {
    JobOptions& job = arguments.job;
    const Problem problem = read_job_problem(job.deck, arguments.overrides);
    if (job.results.empty()) job.results = results_path(job.deck);
    job.existing = arguments.force ? Existing::replace : Existing::refuse;
    return run_job(problem, job);
}

}  // namespace

void add_run_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<RunArguments>();
    CLI::App* verb = program.add_subcommand("run", "Run a deck and write its results");
    verb->add_option("DECK", arguments->job.deck, "Deck (TOML); docs/deck.md lists its keys")->required();
    verb->add_option(
        "-o,--output", arguments->job.results, "Results file [the deck's name with .vtkhdf, in this folder]");
    verb->add_option(
            "--set", arguments->overrides, "KEY=VALUE: change a key of the deck, say analysis.time_step=0.01")
        ->allow_extra_args(false);
    add_job_options(*verb, arguments->job);
    verb->add_flag("--force", arguments->force, "Overwrite an existing results file");
    verb->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace gxrod
