#include <algorithm>
#include <memory>

#include "analyses/dynamic.hpp"
#include "analyses/memory_estimate.hpp"
#include "analyses/mesh_frequencies.hpp"
#include "analyses/model_examination.hpp"
#include "analyses/model_summary.hpp"
#include "deck/problem.hpp"
#include "exit_code.hpp"
#include "job.hpp"
#include "model/evaluation_error.hpp"
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

// Whether a load changes along its rod, so that it is integrated.
bool has_uneven_loads(const Model& model) {
    const auto is_uneven = [](const LineFunction& component) { return !component.form().is_even; };
    return std::any_of(
        model.distributed_loads.begin(), model.distributed_loads.end(), [&](const DistributedLoad& load) {
            return std::any_of(load.force.begin(), load.force.end(), is_uneven) ||
                   std::any_of(load.moment.begin(), load.moment.end(), is_uneven);
        });
}

// The first thing that a run would do: a model without inertia somewhere is found here, and a load without an
// integral. Throws EvaluationError.
int start_analysis(const Problem& problem) {
    const auto* dynamic = std::get_if<DynamicSettings>(&problem.analysis);
    if (dynamic == nullptr) {
        if (has_uneven_loads(problem.model)) make_analysis(problem.model, problem.analysis)->start();
        return exit_done;
    }
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
    try {
        return start_analysis(problem);
    } catch (const EvaluationError& error) {
        say(stderr, "gxrod: {}\n", error.what());
        return exit_bad_input;
    }
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
