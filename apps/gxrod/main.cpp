#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "deck/rods/imperfections.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/text/fault.hpp"
#include "exit_code.hpp"
#include "machine/file_error.hpp"
#include "machine/instruction_set.hpp"
#include "machine/printable.hpp"
#include "model/version.hpp"
#include "run/imperfect_shapes.hpp"
#include "say.hpp"
#include "verbs.hpp"

namespace {

// `gxrod import` is gxrod-import, if that stands beside this program. Returns if there is none.
void become_program_beside(const std::string& verb, char** argv) {
    std::error_code error;
    const auto folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    if (error || verb.find('/') != std::string::npos) return;
    ::execv((folder / ("gxrod-" + verb)).c_str(), argv + 1);
}

// Throws if the first argument is meant as a verb but is not one, and no program of that name stands beside
// this one.
void check_verb(const CLI::App& program, int argc, char** argv) {
    const std::string verb = argc > 1 ? argv[1] : "-";
    if (verb.empty() || verb[0] == '-') return;
    std::vector<std::string> verbs;
    for (const CLI::App* known : program.get_subcommands({})) verbs.push_back(known->get_name());
    if (std::find(verbs.begin(), verbs.end(), verb) != verbs.end()) return;
    become_program_beside(verb, argv);
    throw CLI::ValidationError("gxrod has no verb '" + verb + "'" + gxrod::did_you_mean(verb, verbs));
}

// Throws if the environment asks for an instruction set that the processor lacks.
void check_instruction_set() {
    try {
        gxrod::find_instruction_set();
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError(error.what());
    }
}

// If one of them is closed, a file of ours would take its number and receive what is printed.
void open_standard_files() {
    for (int descriptor = 0; descriptor <= 2; ++descriptor) {
        if (::fcntl(descriptor, F_GETFD) < 0) ::open("/dev/null", O_RDWR);
    }
}

// Removes the "--" of a batch and what follows, the options of sbatch, from the arguments.
std::optional<std::vector<std::string>> take_sbatch_options(int& argc, char** argv) {
    if (argc < 2 || argv[1] != std::string("batch")) return std::nullopt;
    char** end = argv + argc;
    char** dashes = std::find(argv, end, std::string("--"));
    if (dashes == end) return std::nullopt;
    argc = static_cast<int>(dashes - argv);
    return std::vector<std::string>(dashes + 1, end);
}

// Runs the verb; errors become a message and an exit code.
int run_program(int argc, char** argv) {
    CLI::App program{"gxrod: geometrically exact rods and rigid bodies in motion"};
    program.set_version_flag("--version", std::string("gxrod ") + gxrod::version);
    program.require_subcommand(1);
    program.failure_message([](const CLI::App*, const CLI::Error& error) {
        return std::string("gxrod: ") + error.what() + "\nTry 'gxrod --help' or 'gxrod VERB --help'.\n";
    });
    program.footer(
        "gxrod import and gxrod plot are programs of their own: gxrod-import, gxrod-plot.\n"
        "Exit codes: 0 done, 1 internal error or too little memory, 2 usage or deck fault, 3 did not "
        "converge,\n"
        "4 a file could not be read or written, 5 a verification missed its reference, 130 interrupted.");
    int exit_code = gxrod::exit_done;
    gxrod::add_init_verb(program, exit_code);
    gxrod::add_run_verb(program, exit_code);
    gxrod::add_resume_verb(program, exit_code);
    gxrod::add_batch_verb(program, exit_code, take_sbatch_options(argc, argv));
    gxrod::add_check_verb(program, exit_code);
    gxrod::add_section_verb(program, exit_code);
    gxrod::add_obstacle_verb(program, exit_code);
    gxrod::add_export_verb(program, exit_code);
    gxrod::add_line_ends_verb(program, exit_code);
    gxrod::add_report_verb(program, exit_code);
    gxrod::add_fmu_verb(program, exit_code);
    gxrod::add_verify_verb(program, exit_code);
    gxrod::add_schema_verb(program, exit_code);
    try {
        check_verb(program, argc, argv);
        check_instruction_set();
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? gxrod::exit_done : gxrod::exit_bad_input;
    }
    return exit_code;
}

// The exit code; reports output that could not be written.
int check_output(int exit_code) {
    const std::string error = gxrod::describe_output_error();
    if (error.empty()) return exit_code;
    gxrod::say(stderr, "gxrod: standard output cannot be written: {}\n", error);
    return exit_code == gxrod::exit_done ? gxrod::exit_file : exit_code;
}

// Where exceptions cannot pass, in a library or before main(), lack of memory still does not abort.
[[noreturn]] void end_without_memory() {
    try {
        if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        gxrod::say_text(stderr, gxrod::out_of_memory);
        std::_Exit(gxrod::exit_internal_error);
    } catch (...) {
    }
    std::abort();
}

// Before anything else that is constructed before main().
struct TerminateHandler {
    TerminateHandler() { std::set_terminate(end_without_memory); }
};
[[gnu::init_priority(101)]] const TerminateHandler terminate_handler;

}  // namespace

int main(int argc, char** argv) {
    open_standard_files();
    gxrod::set_mode_finder(gxrod::find_imperfect_mode);
    try {
        return check_output(run_program(argc, argv));
    } catch (const gxrod::DeckError& error) {
        gxrod::say(stderr, "{}\n", error.what());
        return gxrod::exit_bad_input;
    } catch (const gxrod::FileError& error) {
        gxrod::say(stderr, "gxrod: {}\n", gxrod::printable(error.what()));
        return gxrod::exit_file;
    } catch (const std::bad_alloc&) {
        gxrod::say_text(stderr, gxrod::out_of_memory);
        return gxrod::exit_internal_error;
    } catch (const std::system_error& error) {
        gxrod::say(stderr, "gxrod: {}\n", error.what());
        return gxrod::exit_internal_error;
    } catch (const std::exception& error) {
        gxrod::say(stderr, "gxrod: internal error: {}\n", error.what());
        return gxrod::exit_internal_error;
    }
}
