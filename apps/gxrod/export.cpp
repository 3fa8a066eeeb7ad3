#include <memory>

#include "exit_code.hpp"
#include "model/printable.hpp"
#include "results/csv_export.hpp"
#include "results/list_changes.hpp"
#include "results/series_export.hpp"
#include "say.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

struct ExportArguments {
    std::string results;
    std::string csv;
    std::string series;
    bool force = false;
};

int export_results(const ExportArguments& arguments) {
    if (arguments.csv.empty() && arguments.series.empty()) {
        throw CLI::ValidationError("export", "give --csv DIR, --series DIR, or both");
    }
    for (const std::string& change : list_changes(arguments.results))
        say(stderr, "warning: {}: {}\n", arguments.results, printable(change));
    const Existing existing = arguments.force ? Existing::replace : Existing::refuse;
    if (!arguments.csv.empty()) {
        for (const auto& path : export_csv(arguments.results, arguments.csv, existing)) {
            say(stdout, "{}\n", path.string());
        }
    }
    if (!arguments.series.empty()) {
        say(stdout, "{}\n", export_series(arguments.results, arguments.series, existing).string());
    }
    return exit_done;
}

}  // namespace

void add_export_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<ExportArguments>();
    CLI::App* verb =
        program.add_subcommand("export", "Write results in another form: as tables, frame by frame");
    verb->add_option("RESULTS", arguments->results, "Results file of gxrod run; that of a running job too")
        ->required();
    verb->add_option(
        "--csv", arguments->csv, "Folder for ledger.csv, solver.csv and a history_NAME.csv for each history");
    verb->add_option(
        "--series",
        arguments->series,
        "Folder for NAME_0000.hdf …, a file for each frame, and NAME.hdf.series with their times, "
        "which ParaView 5.11 opens");
    verb->add_flag("--force", arguments->force, "Overwrite files that exist");
    verb->callback([arguments, &exit_code] { exit_code = export_results(*arguments); });
}

}  // namespace gxrod
