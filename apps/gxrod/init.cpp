#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "exit_code.hpp"
#include "first_decks.hpp"
#include "machine/file_error.hpp"
#include "say.hpp"
#include "verbs.hpp"

namespace gxrod {
namespace {

struct InitArguments {
    std::string name;
    std::string output;
    bool force = false;
};

std::vector<std::string> list_names() {
    std::vector<std::string> names;
    for (const FirstDeck& deck : list_first_decks()) names.emplace_back(deck.name);
    return names;
}

int write_first_deck(const InitArguments& arguments) {
    const auto deck = std::ranges::find(list_first_decks(), arguments.name, &FirstDeck::name);
    std::filesystem::path path = arguments.name + ".toml";
    if (!arguments.output.empty()) path = arguments.output;
    std::error_code ignored;
    if (!arguments.force && std::filesystem::exists(path, ignored))
        throw FileError(path, "exists already", "--force replaces it");
    std::ofstream stream(path, std::ios::binary);
    stream << deck->text << std::flush;
    if (!stream) throw FileError(path, "cannot be written");
    say(stdout, "{}: a deck to begin with. Run it: gxrod run {}\n", path.string(), path.string());
    return exit_done;
}

}  // namespace

void add_init_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<InitArguments>();
    CLI::App* verb = program.add_subcommand("init", "Write a commented deck to begin with, which runs");
    verb->add_option("kind", arguments->name, "Which")->required()->check(CLI::IsMember(list_names()));
    verb->add_option("-o,--output", arguments->output, "The deck (default: KIND.toml)");
    verb->add_flag("--force", arguments->force, "Replace a file that exists");
    verb->callback([arguments, &exit_code] { exit_code = write_first_deck(*arguments); });
}

}  // namespace gxrod
