#include <memory>

#include "analyses/dynamic.hpp"
#include "analyses/memory_estimate.hpp"
#include "analyses/mesh_frequencies.hpp"
#include "analyses/model_examination.hpp"
#include "analyses/model_summary.hpp"
#include "deck/problem.hpp"
#include "exit_code.hpp"
#include "job.hpp"
#include "results/results_size.hpp"
#include "say.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

struct CheckArguments {
    std::string deck;
    std::vector<std::string> overrides;
};

std::string describe_size(const Problem& problem) {
    constexpr double megabyte = 1e6;
    const ResultsSize size = estimate_results_size(problem.model, problem.analysis, problem.output);
    const std::string results =
        size.bytes == 0.0 ? "" : fmt::format("results: at least {:.3g} MB\n", size.bytes / megabyte);
    return results +
           fmt::format("memory: about {:.0f} MB\n", estimate_memory(problem.model, size.bytes) / megabyte);
}

int check(const CheckArguments& arguments) {
    const Problem problem = read_job_problem(arguments.deck, arguments.overrides);
    if (!problem.record.title.empty()) say(stdout, "{}\n", problem.record.title);
    say(stdout,
        "{}{}{}{}",
        describe_model(problem.model),
        describe_analysis(problem.analysis),
        describe_output(problem.analysis, problem.output),
        describe_size(problem));
    for (const std::string& note : problem.notes) say(stdout, "note: {}\n", note);
    const std::vector<Finding> findings = examine_model(problem.model, problem.analysis);
    for (const Finding& finding : findings) {
        say(finding.severity == Severity::error ? stderr : stdout, "{}\n", describe(finding));
    }
    if (has_error(findings)) return exit_bad_input;
    const auto* dynamic = std::get_if<DynamicSettings>(&problem.analysis);
    if (dynamic == nullptr) return exit_done;
    // The first thing that a run would do: a model without inertia somewhere is found here.
    DynamicAnalysis analysis(problem.model, *dynamic);
    const EquilibriumReport start = analysis.start();
    if (!start.converged()) {
        say(stderr, "gxrod: {}\n", describe_failure(analysis.explain(start)));
        return exit_not_converged;
    }
    say(stdout,
        "initial accelerations solved; energy at the start {:.6g}\n",
        analysis.ledger_row().kinetic_energy + analysis.ledger_row().strain_energy);
    say(stdout, "{}", describe_frequencies(problem.model, *dynamic));
    return exit_done;
}

}  // namespace

void add_check_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App* verb = program.add_subcommand("check", "Read and examine a deck without running it");
    verb->add_option("DECK", arguments->deck, "Deck (TOML); docs/deck.md lists its keys")->required();
    verb->add_option("--set", arguments->overrides, "KEY=VALUE: change a key of the deck")
        ->allow_extra_args(false);
    verb->callback([arguments, &exit_code] { exit_code = check(*arguments); });
}

}  // namespace gxrod
