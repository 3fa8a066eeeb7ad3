#include "deck/output/build_output_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

constexpr double same_time = 1e-12;  // relative

bool have_time(const std::vector<StagePlan>& stages) {
    return std::ranges::any_of(stages, [](const StagePlan& stage) { return is_timed(stage.analysis); });
}

bool have_paths(const std::vector<StagePlan>& stages) {
    return std::ranges::any_of(stages, [](const StagePlan& stage) { return is_path(stage.analysis); });
}

std::optional<double> read_interval(const CheckedTable& table, const char* key, const BuildContext& context) {
    if (!table.gives(key)) return std::nullopt;
    const double interval = table.get<double>(key);
    double longest = 0.0;
    for (const StagePlan& stage : context.stages) {
        if (is_timed(stage.analysis)) longest = std::fmax(longest, end_of(stage.analysis));
    }
    if (longest / interval > static_cast<double>(largest_step_count))
        context.add_fault(
            table, key, fmt::format("goes {:.3g} times into the time of a stage", longest / interval));
    return interval;
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

void set_times(const CheckedTable& table, const BuildContext& context, OutputSettings& output) {
    if (!table.gives("times")) return;
    output.times = table.get<std::vector<double>>("times");
    const auto add = [&](const std::string& message) { context.add_fault(table, "times", message); };
    if (have_paths(context.stages))
        return add(
            "where stages begin after a path is not known beforehand; output.interval needs no such times");
    for (std::size_t i = 0; i < output.times.size(); ++i) {
        const double time = output.times[i];
        if (time < 0.0) return add(fmt::format("expected times that are not negative, found {:.10g}", time));
        if (i > 0 && time <= output.times[i - 1])
            return add(
                fmt::format("expected times in order; {:.10g} follows {:.10g}", time, output.times[i - 1]));
        const std::string reason = explain_unreached(time, context.stages);
        if (!reason.empty()) return add(reason);
    }
}

}  // namespace

void build_output_times(const CheckedTable& table, const BuildContext& context, OutputSettings& output) {
    if (!have_time(context.stages)) {
        for (const char* key : {"interval", "times", "history_interval"}) {
            if (table.gives(key))
                context.add_fault(
                    table,
                    key,
                    fmt::format("only a dynamic or quasi-static analysis has time between its "
                                "steps{}",
                                std::string(key) == "history_interval" ? "" : "; every = … counts steps"));
        }
        return;
    }
    output.interval = read_interval(table, "interval", context);
    output.history_interval = read_interval(table, "history_interval", context);
    set_times(table, context, output);
}

}  // namespace gxrod
