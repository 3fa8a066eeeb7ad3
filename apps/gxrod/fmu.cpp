#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "deck/problem.hpp"
#include "exit_code.hpp"
#include "face/fmu_run.hpp"
#include "machine/file_error.hpp"
#include "machine/zip_archive.hpp"
#include "model/settings/analysis_traits.hpp"
#include "say.hpp"
#include "verbs.hpp"

namespace gxrod {
namespace {

struct FmuArguments {
    std::string deck;
    std::string output;
    std::vector<std::string> overrides;
    bool force = false;
};

// The library of FMUs is in the folder of the program, or in lib/gxrod of an installed one.
std::string read_fmu_library() {
    namespace fs = std::filesystem;
    const std::string file = std::string(fmu_model_identifier) + ".so";
    std::error_code error;
    const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    std::vector<fs::path> places{folder / file, folder / ".." / "lib" / "gxrod" / file};
    if (const char* given = std::getenv("GXROD_FMU_LIBRARY")) places = {given};
    for (const fs::path& place : places) {
        std::ifstream library(place, std::ios::binary);
        if (library) return {std::istreambuf_iterator<char>(library), {}};
    }
    throw FileError(places.front(),
                    "there is no such file: the library that FMUs need. The target gxrod_fmu builds it; "
                    "GXROD_FMU_LIBRARY names another place");
}

int pack_fmu(const FmuArguments& arguments) {
    namespace fs = std::filesystem;
    const Problem problem = read_problem(arguments.deck, arguments.overrides);
    for (const StagePlan& stage : problem.stages) {
        if (is_timed(stage.analysis)) continue;
        say(stderr,
            "gxrod: {}: an FMU moves in time; expected stages of kind dynamic or quasi-static alone\n",
            arguments.deck);
        return exit_bad_input;
    }
    const fs::path output =
        arguments.output.empty() ? fs::path(arguments.deck).stem().string() + ".fmu" : arguments.output;
    if (fs::exists(output) && !arguments.force) throw FileError(output, "exists; --force replaces it");
    std::map<std::string, std::string> files;
    try {
        files = list_fmu_files(problem);
    } catch (const std::invalid_argument& error) {
        say(stderr, "gxrod: {}: {}\n", arguments.deck, error.what());
        return exit_bad_input;
    }
    files[std::string("binaries/x86_64-linux/") + fmu_model_identifier + ".so"] = read_fmu_library();
    std::ofstream file(output, std::ios::binary);
    file << make_zip(files) << std::flush;
    if (!file) throw FileError(output, "cannot be written");
    static constexpr std::array<const char*, 4> words{"", "parameter", "input", "output"};
    for (const FmuVariable& variable : list_fmu_variables(problem)) {
        if (variable.causality != FmuVariable::Causality::independent)
            say(stdout, "{} {}\n", words[static_cast<std::size_t>(variable.causality)], variable.name);
    }
    say(stdout, "FMU: {}\n", output.string());
    return exit_done;
}

}  // namespace

void add_fmu_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<FmuArguments>();
    CLI::App* verb = program.add_subcommand(
        "fmu", "Pack a deck as an FMU (FMI 3.0, co-simulation), for other programs to drive");
    verb->add_option("DECK", arguments->deck, "Deck (TOML)")->required();
    verb->add_option("-o,--output", arguments->output, "File to write [default: the deck's name, .fmu]");
    verb->add_option("--set", arguments->overrides, "KEY=VALUE: change a key of the deck")
        ->allow_extra_args(false);
    verb->add_flag("--force", arguments->force, "Replace an existing file");
    verb->callback([arguments, &exit_code] { exit_code = pack_fmu(*arguments); });
}

}  // namespace gxrod
