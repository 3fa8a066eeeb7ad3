#include <memory>

#include "exit_code.hpp"
#include "results/export/line_end_table.hpp"
#include "results/file/guarded_reading.hpp"
#include "results/file/output_file.hpp"
#include "say.hpp"
#include "verbs.hpp"
#include "window_options.hpp"

namespace gxrod {
namespace {

struct LineEndArguments {
    std::string results;
    std::string csv;
    WindowRequest window;
    bool force = false;
};

int print_ends(const LineEndArguments& arguments) {
    const GuardedReading reading(arguments.results);
    if (!reading.doubt().empty()) say(stderr, "warning: {}: {}\n", arguments.results, reading.doubt());
    const Existing existing = arguments.force ? Existing::replace : Existing::refuse;
    say_text(stdout, reading.read([&] {
        const std::vector<LineEndRow> rows = read_line_ends(arguments.results, arguments.window);
        if (!arguments.csv.empty()) {
            check_export_file(arguments.csv, existing);
            write_csv(arguments.csv, make_columns(rows));
        }
        return print_line_ends(rows);
    }));
    return exit_done;
}

}  // namespace

void add_line_ends_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<LineEndArguments>();
    CLI::App* verb = program.add_subcommand("line-ends",
                                            "Print a table of the ends of lines: tension, shear, moment and "
                                            "angles, when they are least and largest");
    verb->add_option("RESULTS", arguments->results, "Results file of a deck with output.line_ends")
        ->required();
    verb->add_option("--csv", arguments->csv, "File for the table, with all digits");
    add_window_options(*verb, arguments->window);
    verb->add_flag("--force", arguments->force, "Overwrite a file that exists");
    verb->callback([arguments, &exit_code] { exit_code = print_ends(*arguments); });
}

}  // namespace gxrod
