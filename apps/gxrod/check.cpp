#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <thread>

#include "analyses/dynamic.hpp"
#include "check/findings/plane_findings.hpp"
#include "check/findings/plausibility.hpp"
#include "check/findings/unit_questions.hpp"
#include "check/mesh_frequencies.hpp"
#include "check/model_examination.hpp"
#include "check/step_advice.hpp"
#include "check/summaries/memory_estimate.hpp"
#include "check/summaries/model_summary.hpp"
#include "deck/problem.hpp"
#include "deck/reading/input_uses.hpp"
#include "deck/text/fault.hpp"
#include "exit_code.hpp"
#include "job.hpp"
#include "machine/file_error.hpp"
#include "machine/printable.hpp"
#include "model/evaluation_error.hpp"
#include "results/results_size.hpp"
#include "say.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

struct CheckArguments {
    std::string deck;
    std::vector<std::string> overrides;
    bool all = false;
    bool watch = false;
};

// Of a terminal; longer texts are shortened.
constexpr long lines_of_screen = 50;

std::string describe_size(const Problem& problem) {
    constexpr double megabyte = 1e6;
    const ResultsSize size = estimate_results_size(problem.model, problem.stages, problem.output);
    const std::string results =
        size.bytes == 0.0 ? "" : fmt::format("results: at least {:.3g} MB\n", size.bytes / megabyte);
    return results +
           fmt::format("memory: about {:.0f} MB\n", estimate_memory(problem.model, size.bytes) / megabyte);
}

// What the deck says that bodies look like, a line each: its size shows a wrong scale.
std::string describe_looks(const Problem& problem) {
    std::string text;
    for (const BodyOutline& outline : problem.outlines) {
        if (!outline.is_given || outline.points.empty()) continue;
        Vec3 least = outline.points.front(), most = least;
        for (const Vec3& point : outline.points) {
            least = least.cwiseMin(point);
            most = most.cwiseMax(point);
        }
        const Vec3 size = most - least;
        text += fmt::format("looks of body {}: {:.4g} × {:.4g} × {:.4g} along its axes, {} triangles\n",
                            problem.model.bodies[static_cast<std::size_t>(outline.body)].name,
                            size[0],
                            size[1],
                            size[2],
                            outline.triangles.size());
    }
    return text;
}

// What is printed about a model before anything is solved.
struct CheckText {
    std::vector<ItemList> lists;
    std::string rest;  // total, analysis, output, sizes
    std::vector<std::string> notes, warnings, errors;
};

CheckText describe_problem(const Problem& problem) {
    CheckText text;
    const DeckNode deck = read_toml(problem.record.text, problem.record.name);
    text.lists = list_model(problem.model, {find_input_uses(deck), list_table_names(deck, "chamber")});
    text.rest = describe_total(problem.model) + describe_looks(problem);
    for (const StagePlan& stage : problem.stages) {
        if (!stage.name.empty()) text.rest += "stage " + stage.name + ": ";
        text.rest += describe_analysis(stage.analysis);
    }
    text.rest += describe_signals(problem.signals, problem.output) +
                 describe_output(problem.stages, problem.output) + describe_size(problem);
    if (const std::string plane = suggest_plane(problem.model); !plane.empty())
        text.notes.push_back("note: " + plane);
    for (const std::string& note : problem.notes) text.notes.push_back("note: " + note);
    for (const Finding& finding : examine_stages(problem.model, problem.stages)) {
        (finding.severity == Severity::error ? text.errors : text.warnings).push_back(describe(finding));
    }
    for (const Finding& question : question_model(problem.model, problem.stages))
        text.warnings.push_back(describe(question));
    for (const Finding& question : question_units(problem.model, problem.record.units))
        text.warnings.push_back(describe(question));
    return text;
}

bool fits_screen(const CheckText& text) {
    long lines = count_lines(text.rest) + std::ssize(text.notes) + std::ssize(text.warnings);
    for (const ItemList& list : text.lists) lines += count_lines(describe(list, Detail::all));
    return lines <= lines_of_screen;
}

void say_lines(std::FILE* stream, const std::vector<std::string>& sentences, Detail detail) {
    for (const std::string& line : detail == Detail::all ? sentences : sum_up_repeats(sentences)) {
        say(stream, "{}\n", line);
    }
}

void say_problem(const CheckText& text, bool all) {
    const Detail detail = all || fits_screen(text) ? Detail::all : Detail::shortened;
    for (const ItemList& list : text.lists) say(stdout, "{}", describe(list, detail));
    say(stdout, "{}", text.rest);
    say_lines(stdout, text.notes, detail);
    say_lines(stdout, text.warnings, detail);
    say_lines(stderr, text.errors, detail);
    if (detail == Detail::shortened)
        say(stdout, "repeated parts are summarized; gxrod check --all lists everything\n");
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

// The first step of a run: finds a model without inertia somewhere, and a load without an integral. Throws
// EvaluationError.
int start_analysis(const Problem& problem) {
    const auto* dynamic = std::get_if<DynamicSettings>(&problem.analysis());
    if (dynamic == nullptr || !dynamic->has_inertia) {
        if (has_uneven_loads(problem.model)) make_analysis(problem.model, problem.analysis())->start();
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
    say(stdout,
        "{}{}",
        describe_frequencies(problem.model, *dynamic),
        describe_turning(problem.model, *dynamic));
    return exit_done;
}

int check(const CheckArguments& arguments) {
    const Problem problem = read_job_problem(arguments.deck, arguments.overrides);
    if (!problem.record.title.empty()) say(stdout, "{}\n", problem.record.title);
    const CheckText text = describe_problem(problem);
    say_problem(text, arguments.all);
    if (!text.errors.empty()) return exit_bad_input;
    try {
        return start_analysis(problem);
    } catch (const EvaluationError& error) {
        say(stderr, "gxrod: {}\n", error.what());
        return exit_bad_input;
    }
}

// When the deck and the files in its folder were last written.
std::map<std::filesystem::path, std::filesystem::file_time_type> list_times(const std::string& deck) {
    std::map<std::filesystem::path, std::filesystem::file_time_type> times;
    std::filesystem::path folder = std::filesystem::path(deck).parent_path();
    if (folder.empty()) folder = ".";
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const auto time = entry.last_write_time(ignored);
        if (!ignored && entry.is_regular_file(ignored)) times[entry.path()] = time;
    }
    return times;
}

// Checks; says what is wrong with the deck and its files.
void check_once(const CheckArguments& arguments) {
    try {
        if (check(arguments) == exit_done) say(stdout, "no errors\n");
    } catch (const DeckError& error) {
        say(stderr, "{}\n", error.what());
    } catch (const FileError& error) {
        say(stderr, "gxrod: {}\n", printable(error.what()));
    }
}

// Checks again whenever a file in the folder of the deck has changed; ends when it is interrupted.
[[noreturn]] void check_on_each_save(const CheckArguments& arguments) {
    constexpr std::chrono::milliseconds pause{300};
    while (true) {
        const auto before = list_times(arguments.deck);
        const std::time_t now = std::time(nullptr);
        say(stdout,
            "--- {:02}:{:02}:{:02}\n",
            std::localtime(&now)->tm_hour,
            std::localtime(&now)->tm_min,
            std::localtime(&now)->tm_sec);
        check_once(arguments);
        std::fflush(stdout);
        while (list_times(arguments.deck) == before) std::this_thread::sleep_for(pause);
    }
}

}  // namespace

void add_check_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App* verb = program.add_subcommand("check", "Read and examine a deck without running it");
    verb->add_option("DECK", arguments->deck, "Deck (TOML); docs/deck.md lists its keys")->required();
    verb->add_option("--set", arguments->overrides, "KEY=VALUE: change a key of the deck")
        ->allow_extra_args(false);
    verb->add_flag("--all", arguments->all, "List every part, note and warning of a long deck");
    verb->add_flag("--watch",
                   arguments->watch,
                   "Check again whenever a file in the deck's folder is saved, until Ctrl-C");
    verb->callback([arguments, &exit_code] {
        if (arguments->watch) check_on_each_save(*arguments);
        exit_code = check(*arguments);
    });
}

}  // namespace gxrod
