#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "deck/problem.hpp"
#include "exit_code.hpp"
#include "job.hpp"
#include "model/settings/analysis_traits.hpp"
#include "say.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

struct ResumeArguments {
    JobOptions job;
    std::vector<std::string> overrides;
};

std::string describe_end(const AnalysisSettings& analysis, double time, const std::string& results) {
    if (is_path(analysis)) {
        return fmt::format(
            "{} has followed its path to the end; nothing was changed. --set analysis.until.t=… makes it "
            "longer\n",
            results);
    }
    if (!is_timed(analysis)) {
        return fmt::format("{} is at its end, load factor 1; nothing was changed\n", results);
    }
    return fmt::format(
        "{} is at its end, t = {:.10g}; nothing was changed. --set analysis.end_time=… makes it last "
        "longer\n",
        results,
        time);
}

int resume(ResumeArguments& arguments) {
    JobOptions& job = arguments.job;
    ResumableFile file(job.results);
    const Problem problem = read_resumption(file.deck(), job.deck, arguments.overrides);
    const RestartRecord& record = file.place().record;
    const auto later = problem.stages.begin() + std::min(record.stage + 1, std::ssize(problem.stages));
    const bool is_in_last = std::none_of(
        later, problem.stages.end(), [](const StagePlan& stage) { return has_steps(stage.analysis); });
    const AnalysisSettings& last = std::prev(later)->analysis;
    const double time = record.axis_start + record.steps.time;
    // A path is resumed before its first critical point.
    const bool is_same_path = is_path(last) && arguments.overrides.empty() && job.deck.empty();
    const bool is_at_end = is_in_last && (is_same_path || record.steps.time == end_of(last));
    // A killed run can be at its end without being closed.
    if (is_at_end && file.is_complete() && job.summary.empty()) {
        if (job.prints()) say(stdout, "{}", describe_end(last, time, job.results));
        return exit_done;
    }
    if (job.deck.empty()) job.deck = file.deck().name;
    return run_job(problem, job, &file);
}

}  // namespace

void add_resume_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<ResumeArguments>();
    CLI::App* verb =
        program.add_subcommand("resume", "Continue a run that was stopped or killed, or make it last longer");
    verb->add_option("RESULTS", arguments->job.results, "Results file of gxrod run to continue")->required();
    verb->add_option(
        "--deck",
        arguments->job.deck,
        "Deck to continue with [the one in the results]; its title, units, output, histories and, "
        "of [analysis] or [[stage]], end_time, time_step, steps, adaptive, newton, linear_solver, and of a "
        "path "
        "until, its steps, at, critical and branches can differ");
    verb->add_option("--set",
                     arguments->overrides,
                     "KEY=VALUE: change such a key of the deck, say analysis.end_time=20")
        ->allow_extra_args(false);
    add_job_options(*verb, arguments->job);
    verb->callback([arguments, &exit_code] { exit_code = resume(*arguments); });
}

}  // namespace gxrod
