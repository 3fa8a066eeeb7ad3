#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "deck/suggestion.hpp"
#include "exit_code.hpp"
#include "figures.hpp"
#include "say.hpp"
#include "verbs.hpp"
#include "verification/study.hpp"

namespace gxrod {

namespace {

struct VerifyArguments {
    std::vector<std::string> names;
    std::vector<long> steps;
    std::string figures;
    bool all = false;
    bool list = false;
    bool json = false;
};

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

int verify(const VerifyArguments& arguments) {
    if (arguments.list) {
        std::size_t width = 0;
        for (const Study& study : studies()) width = std::max(width, study.name.size());
        for (const Study& study : studies()) say(stdout, "{:<{}}  {}\n", study.name, width, study.sentence);
        return exit_done;
    }
    bool matches = true;
    nlohmann::ordered_json json;
    for (const Study* study : choose_studies(arguments)) {
        const StudyResult result = study->run({arguments.steps, arguments.figures});
        matches = matches && result.matches;
        json[study->name] = result.json;
        if (!arguments.json) say(stdout, "{}: {}\n{}\n", study->name, study->sentence, result.table);
        if (!result.matches) say(stderr, "gxrod: {} missed its reference\n", study->name);
    }
    if (arguments.json) say(stdout, "{}\n", json.dump(2));
    if (!arguments.figures.empty()) draw_figures(arguments.figures);
    return matches ? exit_done : exit_verification;
}

}  // namespace

void add_verify_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<VerifyArguments>();
    CLI::App* verb = program.add_subcommand("verify", "Run built-in verification studies");
    verb->add_option("NAME", arguments->names, "Studies; --list names them");
    verb->add_option("--steps", arguments->steps, "Numbers of steps of rubin2007 [50,100,200,400,800,1600]")
        ->delimiter(',')
        ->check(CLI::Range(2L, 10'000'000L));
    verb->add_option(
        "--figures", arguments->figures, "Write data and pictures of the paper's figures to this folder");
    verb->add_flag("--all", arguments->all, "Run every study");
    verb->add_flag("--list", arguments->list, "List the studies");
    verb->add_flag("--json", arguments->json, "Print JSON instead of tables");
    verb->footer("Exit code 5 if a value misses its reference.");
    verb->callback([arguments, &exit_code] { exit_code = verify(*arguments); });
}

}  // namespace gxrod
