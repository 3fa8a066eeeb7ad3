#include <fmt/core.h>

#include <memory>

#include "deck/problem.hpp"
#include "exit_code.hpp"
#include "job.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

struct ResumeArguments {
    std::string results;
    std::string deck;
    std::vector<std::string> overrides;
    std::string summary;
    int threads = 1;
    bool quiet = false;
};

double end_of(const AnalysisSettings& analysis) {
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    return dynamic == nullptr ? 1.0 : dynamic->end_time;
}

std::string describe_end(const AnalysisSettings& analysis, double time, const std::string& results) {
    if (std::holds_alternative<StaticSettings>(analysis)) {
        return fmt::format("{} is at its end, load factor 1: nothing to do\n", results);
    }
    return fmt::format(
        "{} is at its end, t = {:.10g}; --set analysis.end_time=… makes it last longer\n", results, time);
}

int resume(const ResumeArguments& arguments) {
    ResumableFile file(arguments.results);
    const Problem problem = read_resumption(file.deck(), arguments.deck, arguments.overrides);
    const double time = file.place().record.steps.time;
    const bool tells = !arguments.quiet && arguments.summary != "-";
    if (time == end_of(problem.analysis)) {
        if (tells) fmt::print("{}", describe_end(problem.analysis, time, arguments.results));
        return exit_done;
    }
    if (tells) fmt::print("{} goes on from t = {:.10g}\n", arguments.results, time);
    const std::string deck = arguments.deck.empty() ? file.deck().name : arguments.deck;
    return run_job(problem, {deck, arguments.results, arguments.summary, arguments.quiet}, &file);
}

}  // namespace

void add_resume_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<ResumeArguments>();
    CLI::App* verb =
        program.add_subcommand("resume", "Go on with a run that was ended, killed, or is to last longer");
    verb->add_option("RESULTS", arguments->results, "Results file of gxrod run, which is continued")
        ->required();
    verb->add_option("--deck",
                     arguments->deck,
                     "Deck to go on with [the one in the results]; of it title, units, output, histories and "
                     "of [analysis] end_time, time_step, steps, adaptive, newton, linear_solver may differ");
    verb->add_option("--set",
                     arguments->overrides,
                     "KEY=VALUE: change such a key of the deck, say analysis.end_time=20")
        ->allow_extra_args(false);
    verb->add_option("--threads", arguments->threads, "Threads; this version runs on one")
        ->check(CLI::Range(1, 1));
    verb->add_option(
        "--summary", arguments->summary, "Write a summary of the run as JSON to a file, or - for stdout");
    verb->add_flag("--quiet", arguments->quiet, "Say nothing unless something is wrong");
    verb->callback([arguments, &exit_code] { exit_code = resume(*arguments); });
}

}  // namespace gxrod
