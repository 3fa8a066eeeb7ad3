#include "verify_deck.hpp"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <stdexcept>

#include "check/model_examination.hpp"
#include "exit_code.hpp"
#include "report/study_page.hpp"
#include "results/file/output_file.hpp"
#include "say.hpp"
#include "study/deck_study_text.hpp"
#include "study/studied_stage.hpp"

namespace gxrod {

namespace {

volatile std::sig_atomic_t is_asked_to_end = 0;

// The first signal ends the study after the current step, with what is known; the second ends it at once.
extern "C" void ask_study_to_end(int signal) {
    is_asked_to_end = 1;
    std::signal(signal, SIG_DFL);
}

// Reports what is suspicious; returns whether the model can be run.
bool examine(const Problem& problem, const std::string& deck) {
    const std::vector<Finding> findings = problem.stages.size() > 1
                                              ? examine_stages(problem.model, problem.stages)
                                              : examine_model(problem.model, problem.analysis());
    for (const Finding& finding : findings) {
        if (finding.severity != Severity::note) say(stderr, "{}: {}\n", deck, describe(finding));
    }
    return !has_error(findings);
}

void print_run(const VariantRun& run, double cost_of_rest) {
    say(stdout, "{}", describe_run(run));
    if (run.variant.kind == VariantKind::as_it_is && run.is_whole())
        say(stdout, "  the others will take about {:.2g} s\n", cost_of_rest * run.seconds);
    std::fflush(stdout);
}

int exit_code_of(const DeckStudy& study) {
    if (!study.runs.empty() && !study.runs.front().is_whole()) return exit_not_converged;
    if (study.is_interrupted) return exit_interrupted;
    return study.is_sound() ? exit_done : exit_verification;
}

}  // namespace

int verify_deck(const VerifyDeckArguments& arguments) {
    const Existing existing = arguments.force ? Existing::replace : Existing::refuse;
    if (!arguments.page.empty()) check_export_file(arguments.page, existing);
    const DeckTemplate deck(arguments.deck);
    Problem problem = deck.build(arguments.overrides);
    DeckStudyOptions options;
    try {
        options.stage = find_studied_stage(problem, arguments.stage);
    } catch (const std::invalid_argument& error) {
        say(stderr, "{}: {}\n", arguments.deck, error.what());
        return exit_bad_input;
    }
    const bool has_stages = problem.record.stages.size() > 1;
    end_with_stage(options.stage, problem);
    if (!examine(problem, arguments.deck)) return exit_bad_input;
    const std::vector<DeckVariant> variants = list_variants(problem, arguments.levels);
    std::signal(SIGINT, ask_study_to_end);
    std::signal(SIGTERM, ask_study_to_end);
    options.seed = arguments.seed;
    options.tolerance = arguments.tolerance;
    options.is_interrupted = [] { return is_asked_to_end != 0; };
    if (!arguments.json) {
        if (!problem.record.title.empty()) say(stdout, "{}\n", problem.record.title);
        if (has_stages) say(stdout, "stage {}\n", problem.stages.back().name);
        say(stdout, "{}{}", describe_plan(variants), run_head());
        std::fflush(stdout);
        options.report_run = [&](const VariantRun& run) { print_run(run, total_cost(variants) - 1.0); };
    }
    const DeckStudy study = study_deck(deck, arguments.overrides, variants, options);
    if (arguments.json) {
        say(stdout, "{}\n", to_json(study, false).dump(2));
    } else {
        if (!study.runs.empty() && study.runs.front().is_whole())
            say(stdout, "\n{}\n{}", describe_errors(study), describe_properties(study));
        say(stdout, "\n");
        for (const std::string& sentence : judge(study)) say(stdout, "- {}\n", sentence);
    }
    if (!arguments.page.empty()) {
        write_study_page(to_json(study, true), arguments.page, existing);
        if (!arguments.json) say(stdout, "\nPage: {}\n", arguments.page);
    }
    return exit_code_of(study);
}

}  // namespace gxrod
