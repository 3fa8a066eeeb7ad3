#include <functional>
#include <memory>
#include <optional>

#include "exit_code.hpp"
#include "results/export/along_export.hpp"
#include "results/export/bodies_export.hpp"
#include "results/export/contacts_export.hpp"
#include "results/export/csv_export.hpp"
#include "results/export/envelope_export.hpp"
#include "results/export/range_export.hpp"
#include "results/export/series_export.hpp"
#include "results/file/guarded_reading.hpp"
#include "say.hpp"
#include "verbs.hpp"
#include "window_options.hpp"

namespace gxrod {

namespace {

struct ExportArguments {
    std::string results;
    std::string csv;
    std::string series;
    std::string along;
    std::string envelopes;
    std::string ranges;
    std::string rod;  // of ranges
    WindowRequest window;
    std::string folder = ".";
    std::optional<double> time;
    bool contacts = false;
    bool bodies = false;
    bool all = false;
    bool force = false;
};

// Returns the names of what it wrote, a line each.
std::string export_along_rod(const ExportArguments& arguments, Existing existing) {
    const AlongExport done = export_along(
        arguments.results, arguments.folder, {arguments.along, arguments.time, arguments.all}, existing);
    std::string written;
    for (const auto& path : done.files) written += path.lexically_normal().string() + "\n";
    if (arguments.time && done.times.size() == 1 && done.times[0] != *arguments.time)
        say(stderr, "the frame nearest to {:.10g} is that at {:.10g}\n", *arguments.time, done.times[0]);
    return written;
}

int export_results(const ExportArguments& arguments) {
    if (arguments.csv.empty() && arguments.series.empty() && arguments.along.empty() &&
        arguments.envelopes.empty() && arguments.ranges.empty()) {
        throw CLI::ValidationError(
            "export",
            "give --csv DIR, --series DIR, --along ROD, --envelopes DIR, --ranges DIR, or several of them");
    }
    const GuardedReading reading(arguments.results);
    if (!reading.doubt().empty()) say(stderr, "warning: {}: {}\n", arguments.results, reading.doubt());
    const Existing existing = arguments.force ? Existing::replace : Existing::refuse;
    const auto write = [&](const std::function<std::string()>& form) {
        say_text(stdout, reading.read(form));
    };
    if (!arguments.csv.empty()) {
        write([&] {
            std::string written;
            for (const auto& path : export_csv(arguments.results, arguments.csv, existing))
                written += path.string() + "\n";
            return written;
        });
    }
    if (!arguments.series.empty()) {
        write([&] { return export_series(arguments.results, arguments.series, existing).string() + "\n"; });
    }
    if (arguments.contacts) {
        write([&] { return export_contacts(arguments.results, arguments.series, existing).string() + "\n"; });
    }
    if (arguments.bodies) {
        write([&] { return export_bodies(arguments.results, arguments.series, existing).string() + "\n"; });
    }
    if (!arguments.envelopes.empty()) {
        write([&] {
            return export_envelopes(arguments.results, arguments.envelopes, existing).string() + "\n";
        });
    }
    if (!arguments.ranges.empty()) {
        write([&] {
            std::string written;
            for (const auto& path : export_ranges(
                     arguments.results, arguments.ranges, arguments.rod, arguments.window, existing))
                written += path.string() + "\n";
            return written;
        });
    }
    if (!arguments.along.empty()) write([&] { return export_along_rod(arguments, existing); });
    return exit_done;
}

}  // namespace

void add_export_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<ExportArguments>();
    CLI::App* verb =
        program.add_subcommand("export", "Write results in another form: as tables, frame by frame");
    verb->add_option("RESULTS", arguments->results, "Results file of gxrod run, also of a running job")
        ->required();
    verb->add_option(
        "--csv", arguments->csv, "Folder for ledger.csv, solver.csv and a history_NAME.csv for each history");
    CLI::Option* series = verb->add_option(
        "--series",
        arguments->series,
        "Folder for NAME_0000.hdf …, a file for each frame, and NAME.hdf.series with their times, "
        "which ParaView 5.11 opens");
    verb->add_flag(
            "--contacts",
            arguments->contacts,
            "Also contacts.vtkhdf in the folder of --series: what touches in each frame, as points with "
            "their forces, for ParaView 5.12 or later")
        ->needs(series);
    verb->add_flag("--bodies",
                   arguments->bodies,
                   "Also bodies.vtkhdf in the folder of --series: what bodies look like at all frames, for "
                   "ParaView 5.12 or later")
        ->needs(series);
    verb->add_option(
        "--envelopes",
        arguments->envelopes,
        "Folder for envelopes.csv: the largest stresses of all steps along the rods, of runs with "
        "stresses in [output]");
    CLI::Option* ranges = verb->add_option(
        "--ranges",
        arguments->ranges,
        "Folder for a range_ROD.csv for each rod: least, largest and mean tension, shear, bending moment, "
        "curvature and stress along it");
    verb->add_option("--rod", arguments->rod, "Rod of --ranges [default: all]")->needs(ranges);
    add_window_options(*verb, arguments->window);
    CLI::Option* along = verb->add_option(
        "--along",
        arguments->along,
        "Name of a rod: along_ROD_nodes.csv and along_ROD_elements.csv get a frame's values along it, from "
        "its start to its end");
    CLI::Option* time = verb->add_option("--time",
                                         arguments->time,
                                         "Time, or load factor, of --along: the nearest frame is taken "
                                         "[default: the last]");
    verb->add_flag("--all", arguments->all, "All frames, of --along")->needs(along)->excludes(time);
    verb->add_option("-o,--output", arguments->folder, "Folder for the tables of --along [default: this one]")
        ->needs(along);
    time->needs(along);
    verb->add_flag("--force", arguments->force, "Overwrite files that exist");
    verb->callback([arguments, &exit_code] { exit_code = export_results(*arguments); });
}

}  // namespace gxrod
