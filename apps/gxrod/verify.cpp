#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "deck/schema/suggestion.hpp"
#include "exit_code.hpp"
#include "figures.hpp"
#include "machine/phase_timer.hpp"
#include "say.hpp"
#include "verbs.hpp"
#include "verification/study.hpp"
#include "verification/validation_table.hpp"
#include "verify_deck.hpp"

namespace gxrod {

namespace {

struct VerifyArguments {
    std::vector<std::string> names;
    std::vector<long> steps;
    std::string figures;
    bool all = false;
    bool list = false;
    bool json = false;
    bool table = false;
    VerifyDeckArguments own;

    // Whether comparisons are printed in one table, not study by study.
    bool prints_table() const { return (all || table) && !json; }
};

// Whether a name is that of a file, not of a study.
bool is_deck(const std::string& name) {
    for (const Study& study : studies()) {
        if (study.name == name) return false;
    }
    return std::filesystem::path(name).has_extension() || std::filesystem::exists(name);
}

std::vector<const Study*> choose_studies(const VerifyArguments& arguments) {
    std::vector<const Study*> chosen;
    for (const Study& study : studies()) {
        const auto& names = arguments.names;
        if (arguments.all || std::find(names.begin(), names.end(), study.name) != names.end())
            chosen.push_back(&study);
    }
    std::vector<std::string> known;
    for (const Study& study : studies()) known.push_back(study.name);
    for (const std::string& name : arguments.names) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        throw CLI::ValidationError("NAME",
                                   fmt::format("there is no study \"{}\"{}; there are {}",
                                               name,
                                               did_you_mean(name, known),
                                               plain_list(known)));
    }
    if (chosen.empty()) throw CLI::ValidationError("NAME", "name a study, or --all, or --list");
    return chosen;
}

StudyResult run_study(const Study& study, const VerifyArguments& arguments, double& seconds) {
    const PhaseTimer timer(seconds);
    return study.run({arguments.steps, arguments.figures});
}

void add_to(ValidationTotals& totals, const StudyResult& result, double seconds) {
    ++totals.studies;
    totals.checks += result.checks.size();
    totals.missed += static_cast<std::size_t>(std::count_if(
        result.checks.begin(), result.checks.end(), [](const Check& check) { return !check.passed(); }));
    totals.seconds += seconds;
}

nlohmann::ordered_json describe_check(const Study& study, const Check& check, double seconds) {
    nlohmann::ordered_json json{
        {"case", study.name}, {"kind", study.kind}, {"source", study.source}, {"case_seconds", seconds}};
    json.update(to_json(check));
    return json;
}

void print(const VerifyArguments& arguments, const Study& study, const StudyResult& result, double seconds) {
    if (arguments.prints_table()) {
        say(stdout, "{}", describe_checks(study, result, seconds));
    } else {
        say(stdout, "{}: {}\n{}\n", study.name, study.sentence, result.table);
    }
    std::fflush(stdout);
}

// Rejects options that do not apply.
void refuse(const CLI::App& verb, const std::vector<std::string>& options, const std::string& whose) {
    for (const std::string& option : options) {
        if (verb.get_option(option)->count() > 0)
            throw CLI::ValidationError(option, fmt::format("is only for {}", whose));
    }
}

int verify(const CLI::App& verb, VerifyArguments& arguments) {
    if (arguments.names.size() == 1 && is_deck(arguments.names.front())) {
        refuse(verb, {"--all", "--table", "--list", "--steps", "--figures"}, "the built-in studies");
        arguments.own.deck = arguments.names.front();
        arguments.own.json = arguments.json;
        return verify_deck(arguments.own);
    }
    refuse(verb, {"--set", "--stage", "--levels", "--tolerance", "--seed", "--output", "--force"}, "a deck");
    if (arguments.list) {
        std::size_t width = 0;
        for (const Study& study : studies()) width = std::max(width, study.name.size());
        for (const Study& study : studies()) say(stdout, "{:<{}}  {}\n", study.name, width, study.sentence);
        return exit_done;
    }
    ValidationTotals totals;
    nlohmann::ordered_json json;
    nlohmann::ordered_json checks = nlohmann::ordered_json::array();
    if (arguments.prints_table()) say(stdout, "{}", validation_head());
    for (const Study* study : choose_studies(arguments)) {
        double seconds = 0.0;
        try {
            const StudyResult result = run_study(*study, arguments, seconds);
            add_to(totals, result, seconds);
            json[study->name] = result.json;
            for (const Check& check : result.checks) checks.push_back(describe_check(*study, check, seconds));
            if (!arguments.json) print(arguments, *study, result, seconds);
            if (!result.matches()) say(stderr, "gxrod: {} missed its reference\n", study->name);
        } catch (const std::runtime_error& error) {
            // As where Newton's method does not converge: the other studies are run all the same.
            ++totals.studies;
            ++totals.missed;
            json[study->name] = {{"failure", error.what()}};
            say(stderr, "gxrod: {} missed its reference: {}\n", study->name, error.what());
        }
    }
    json["checks"] = checks;
    if (arguments.json) say(stdout, "{}\n", json.dump(2));
    if (arguments.prints_table()) say(stdout, "{}", describe_totals(totals));
    if (!arguments.figures.empty()) draw_figures(arguments.figures);
    return totals.missed == 0 ? exit_done : exit_verification;
}

void add_study_options(CLI::App& verb, VerifyArguments& arguments) {
    verb.add_option("--steps", arguments.steps, "Numbers of steps of rubin2007 [50,100,200,400,800,1600]")
        ->delimiter(',')
        ->check(CLI::Range(2L, 10'000'000L));
    verb.add_option(
        "--figures", arguments.figures, "Write data and pictures of the paper's figures to this folder");
}

void add_deck_options(CLI::App& verb, VerifyDeckArguments& own) {
    verb.add_option("--set", own.overrides, "KEY=VALUE: change a key of the deck")->allow_extra_args(false);
    verb.add_option("--stage",
                    own.stage,
                    "Examine this stage of the deck; earlier ones are refined with it [the last that moves]");
    verb.add_option("--levels",
                    own.levels,
                    "How often steps and mesh are halved; 1 assumes orders instead of measuring them, at "
                    "half the cost [2]")
        ->check(CLI::Range(1, 2));
    verb.add_option("--tolerance", own.tolerance, "Acceptable error, relative to the largest change [0.01]")
        ->check(CLI::PositiveNumber);
    verb.add_option("--seed", own.seed, "Seed of the random rotation of the deck [1]");
    verb.add_option("-o,--output", own.page, "Also write the findings on a deck as a page for a browser");
    verb.add_flag("--force", own.force, "Overwrite an existing page");
}

}  // namespace

void add_verify_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<VerifyArguments>();
    CLI::App* verb = program.add_subcommand(
        "verify", "Run built-in verification studies, or examine a deck by running it in several ways");
    verb->add_option("NAME", arguments->names, "Studies, which --list names; or a deck (TOML)");
    verb->add_flag("--all", arguments->all, "Run every study, and print a table of all comparisons");
    verb->add_flag("--table", arguments->table, "Print this table for the named studies");
    verb->add_flag("--list", arguments->list, "List the studies");
    verb->add_flag("--json", arguments->json, "Print JSON instead of tables");
    add_study_options(*verb, *arguments);
    add_deck_options(*verb, arguments->own);
    verb->footer(
        "Exit code 5 if a value misses its reference; of a deck, if its motion depends on orientation,\n"
        "resuming or threads.");
    verb->callback([arguments, verb, &exit_code] { exit_code = verify(*verb, *arguments); });
}

}  // namespace gxrod
