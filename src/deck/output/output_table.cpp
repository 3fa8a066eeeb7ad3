#include "deck/output/output_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cross_section/cross_section.hpp"
#include "deck/output/line_ends.hpp"
#include "deck/output/stress_checks.hpp"
#include "deck/output/stress_criterion.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/table/table.hpp"
#include "model/sections/section_at.hpp"
#include "model/settings/frame_interval.hpp"

namespace gxrod {
namespace {

struct OutputTable : TableHead {
    std::optional<long> every;
    std::optional<double> interval;
    std::optional<std::vector<double>> times;
    std::optional<double> history_interval;
    Compression compression = OutputSettings{}.compression;
    std::optional<std::string> stresses;
    std::optional<TableNames> line_ends;
};

}  // namespace

const TableSpec& output_table() {
    using T = OutputTable;
    // clang-format off
    static const TableSpec table = Table<T>("[output]", "What the results file holds in addition to histories.")
        .key("every", &T::every, "Steps between frames; the first and the last are always written. Left out: 1 up to "
             "500 steps; beyond that the least of 2, 5, 10, 20, 50 … that makes about 500 frames at most; with "
             "adaptive steps one frame in each 500th part of the time.")
            .between(1, static_cast<double>(largest_step_count)).otherwise("what makes about 500 frames at most")
            .also("stride frequency frames save_every")
        .key("interval", &T::interval, "Time between frames, instead: they come at its multiples in each stage with "
             "time, and at the ends of stages, wherever steps end. Steps are not cut: within them the motion is the "
             "scheme's interpolant.")
            .unit("time").above(0).also("dt dt_out frame_interval output_interval save_interval period")
        .key("times", &T::times, "Times of frames, instead, in order: on the axis of the results, on which the first "
             "stage with time begins at 0. The first and the last frame of the run are written too.")
            .unit("time").also("time frame_times output_times save_at saveat")
        .key("history_interval", &T::history_interval, "Histories are recorded at its multiples in each stage with "
             "time, too, in /sampled of the results; in /histories they are at every step.")
            .unit("time").above(0).also("sample_interval sampling_interval sampling history_step")
        .key("compression", &T::compression, "Of frames, without loss. deflate halves them and takes some time of "
             "writing; for models of a thousand nodes and more.")
        .key("stresses", &T::stresses, "Stresses of all rods whose sections have shapes and no law are recorded: "
             "the largest of all steps at both ends and the middle of each element, with place and time, in /envelopes, "
             "those of frames, and /sections. The word is the criterion of exposure, 1/(factor on the resultants at "
             "which the material fails): \"von-mises\" with yield_stress of the material; \"tsai-wu\", \"hashin\" or "
             "\"max-stress\" with its strength, of materials without it von-mises.")
            .also("stress envelope envelopes criterion utilisation utilization")
        .key("line_ends", &T::line_ends, "Rods whose two ends get a history each, ROD_start and ROD_end, with effective "
             "and wall tension, shear force, bending moment, the axis there, force and moment; on a ground also "
             "ROD_ground, where it touches down. gxrod line-ends makes a table of them.")
            .otherwise("no rod").names_of({"rod"}).also("ends")
        .at_most_one_of({"every", "interval", "times"})
        .shown_by(
            "[output]\n"
            "every = 10\n"
            "compression = \"deflate\"\n");
    // clang-format on
    return table;
}

namespace {

constexpr double same_time = 1e-12;  // relative

bool have_time(const std::vector<StagePlan>& stages) {
    return std::ranges::any_of(stages, [](const StagePlan& stage) { return is_timed(stage.analysis); });
}

bool have_paths(const std::vector<StagePlan>& stages) {
    return std::ranges::any_of(stages, [](const StagePlan& stage) { return is_path(stage.analysis); });
}

// Adds a fault if the interval, one of the table's fields, is too short.
void check_interval(const OutputTable& table,
                    const std::optional<double>& interval,
                    const BuildContext& context) {
    if (!interval) return;
    double longest = 0.0;
    for (const StagePlan& stage : context.stages) {
        if (is_timed(stage.analysis)) longest = std::fmax(longest, end_of(stage.analysis));
    }
    if (longest / *interval > static_cast<double>(largest_step_count))
        context.add_fault(
            table, interval, fmt::format("goes {:.3g} times into the time of a stage", longest / *interval));
}

// Why nothing can be written at this time, or "". Stages without time are on the axis, too.
std::string explain_unreached(double time, const std::vector<StagePlan>& stages) {
    const double end = find_axis_end(stages);
    if (time > end * (1.0 + same_time))
        return fmt::format("{:.10g} is after the end of the analysis, {:.10g}", time, end);
    double start = find_axis_start(stages);
    for (const StagePlan& stage : stages) {
        const double stage_end = start + (has_steps(stage.analysis) ? end_of(stage.analysis) : 0.0);
        if (!is_timed(stage.analysis) && time > start * (1.0 + same_time) && time < stage_end)
            return fmt::format("{:.10g} lies in stage {}, which has no time", time, stage.name);
        start = stage_end;
    }
    return "";
}

void check_times(const OutputTable& table, const BuildContext& context) {
    if (!table.times) return;
    const std::vector<double>& times = *table.times;
    const auto add = [&](const std::string& message) { context.add_fault(table, table.times, message); };
    if (have_paths(context.stages))
        return add(
            "where stages begin after a path is not known beforehand; output.interval needs no such times");
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double time = times[i];
        if (time < 0.0) return add(fmt::format("expected times that are not negative, found {:.10g}", time));
        if (i > 0 && time <= times[i - 1])
            return add(fmt::format("expected times in order; {:.10g} follows {:.10g}", time, times[i - 1]));
        const std::string reason = explain_unreached(time, context.stages);
        if (!reason.empty()) return add(reason);
    }
}

// Adds faults for times of a run that has none.
void refuse_times(const OutputTable& table, const BuildContext& context) {
    const std::string message = "only a dynamic or quasi-static analysis has time between its steps";
    const std::string hint = "; every = … counts steps";
    if (table.interval) context.add_fault(table, table.interval, message + hint);
    if (table.times) context.add_fault(table, table.times, message + hint);
    if (table.history_interval) context.add_fault(table, table.history_interval, message);
}

// "beam (its section has a law, …), mast", of rods whose stresses are not recorded.
std::string list_without_stress(const Model& model) {
    std::string list;
    for (std::size_t r = 0; r < model.rods.size(); ++r) {
        const RodPlace start{.rod = static_cast<int>(r)};
        if (!find_shapes(model, start).empty()) continue;
        std::string reason = explain_no_stress(model, section_at(model, start));
        if (reason.empty()) reason = "is a tube under pressure, whose stresses a [[history]] of a point has";
        list += fmt::format("{}{} (its section {})", list.empty() ? "" : ", ", model.rods[r].name, reason);
    }
    return list;
}

// What the exposure of all rods compares. Without any yield stress and strength it has only von Mises'
// stresses.
void check_exposures(const OutputTable& table, const BuildContext& context) {
    std::vector<ElasticMaterial> materials;
    for (const ListedShape& one : list_shapes(context.model))
        materials.insert(materials.end(), one.shape->materials.begin(), one.shape->materials.end());
    const std::string path = table.path_of(&table.stresses);
    if (*table.stresses != "von-mises")
        return check_materials_of(*table.stresses, materials, table.place_of(&table.stresses), path, context);
    const auto has_limit = [](const ElasticMaterial& one) { return one.yield_stress || one.strength; };
    if (std::ranges::any_of(materials, has_limit)) note_other_criteria("von-mises", materials, path, context);
}

void set_stresses(const OutputTable& table, const BuildContext& context, OutputSettings& output) {
    if (!table.stresses) return;
    check_criterion(table, table.stresses, context);
    output.stresses = *table.stresses;
    const std::string without = list_without_stress(context.model);
    if (list_shapes(context.model).empty())
        return context.add_fault(table, table.stresses, "no rod has stresses: " + without);
    if (!without.empty()) context.notes.push_back("output.stresses: not those of " + without);
    check_exposures(table, context);
}

void set_output(const OutputTable& table, const BuildContext& context, OutputSettings& output) {
    output.compression = table.compression;
    set_stresses(table, context, output);
    if (table.line_ends) add_line_ends(table, *table.line_ends, context, output.histories);
    if (!have_time(context.stages)) return refuse_times(table, context);
    check_interval(table, table.interval, context);
    check_interval(table, table.history_interval, context);
    check_times(table, context);
    output.interval = table.interval;
    output.history_interval = table.history_interval;
    output.times = table.times.value_or(std::vector<double>());
}

}  // namespace

void set_frame_intervals(BuildContext& context) {
    std::optional<long> every;
    for (const OutputTable& table : tables_of<OutputTable>(context.deck, output_table())) every = table.every;
    for (StagePlan& stage : context.stages)
        stage.frame_interval = every ? *every : choose_frame_interval(stage.analysis);
}

bool records_stresses(const CheckedTable& deck) {
    return std::ranges::any_of(tables_of<OutputTable>(deck, output_table()),
                               [](const OutputTable& table) { return table.stresses.has_value(); });
}

OutputSettings build_output(const BuildContext& context) {
    OutputSettings output;
    output.every = context.stages.front().frame_interval;
    for (const OutputTable& table : tables_of<OutputTable>(context.deck, output_table()))
        set_output(table, context, output);
    return output;
}

}  // namespace gxrod
