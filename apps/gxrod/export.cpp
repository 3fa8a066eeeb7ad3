#include <fmt/core.h>

#include <memory>

#include "exit_code.hpp"
#include "results/csv_export.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

struct ExportArguments {
    std::string results;
    std::string csv;
    bool force = false;
};

int export_results(const ExportArguments& arguments) {
    const Existing existing = arguments.force ? Existing::replace : Existing::refuse;
    for (const auto& path : export_csv(arguments.results, arguments.csv, existing)) {
        fmt::print("{}\n", path.string());
    }
    return exit_done;
}

}  // namespace

void add_export_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<ExportArguments>();
    CLI::App* verb = program.add_subcommand("export", "Write results in another form");
    verb->add_option("RESULTS", arguments->results, "Results file of gxrod run; that of a running job too")
        ->required();
    verb->add_option("--csv",
                     arguments->csv,
                     "Folder for ledger.csv, solver.csv and a history_NAME.csv for each history")
        ->required();
    verb->add_flag("--force", arguments->force, "Overwrite files that exist");
    verb->callback([arguments, &exit_code] { exit_code = export_results(*arguments); });
}

}  // namespace gxrod
