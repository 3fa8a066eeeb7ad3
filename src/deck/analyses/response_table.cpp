#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "deck/analyses/analysis_table.hpp"
#include "deck/analyses/build_response.hpp"
#include "deck/analyses/listed_numbers.hpp"

namespace gxrod {
namespace {

TableSpec make_frequencies(const char* path, const char* unit) {
    Table<NumbersTable> table(path, "");
    return add_numbers(table, unit, 0.0);
}

const TableSpec& omega_table() {
    static const TableSpec table = make_frequencies("analysis.omega", "angle/time");
    return table;
}

const TableSpec& frequency_table() {
    static const TableSpec table = make_frequencies("analysis.frequency", "1/time");
    return table;
}

const TableSpec& excitation_table() {
    using T = ExcitationTable;
    // clang-format off
    static const TableSpec table = Table<T>("analysis.excite[]", "")
        .key("at", &T::at, "The point on which it acts.")
            .required()
        .key("force", &T::force, "Amplitude of the force, global axes.")
            .unit("mass·length/time²")
        .key("moment", &T::moment, "Amplitude of the moment, global axes.")
            .unit("mass·length²/time²")
        .key("phase", &T::phase, "By which it is ahead, rad: it acts as cos(ωt + phase).")
            .unit("angle")
        .at_least_one_of({"force", "moment"});
    // clang-format on
    return table;
}

}  // namespace

void add_response_keys(Table<AnalysisTable>& table) {
    using T = AnalysisTable;
    const Condition response_only{"kind", {"response"}};
    // clang-format off
    table
        .key("omega", &T::omega, omega_table(), "Of the forces, rad per time.")
            .only_for({response_only})
        .key("frequency", &T::frequency, frequency_table(), "The same in cycles per time.")
            .only_for({response_only})
        .key("excite", &T::excite, excitation_table(),
             "Forces that swing with the frequency; loads of the deck stay as they are.")
            .only_for({response_only})
        .key("gravity", &T::gravity, "Instead of a frequency, after a steady stage: gravity, global components when the "
             "frame's axes are the global ones. What of it is across the axis acts once a revolution.")
            .unit("length/time²").only_for({response_only}).also("g once_per_revolution weight");
    // clang-format on
}

namespace {

// Rising.
std::vector<double> list_frequencies(const NumbersTable& table, const BuildContext& context) {
    std::vector<double> values = list_numbers(table, context);
    if (table.values) {
        std::sort(values.begin(), values.end());
        if (values.front() < 0.0)
            context.add_fault(table, table.values, "expected numbers that are not negative");
    } else if (values.back() < values.front()) {
        context.add_fault(
            table,
            table.to,
            fmt::format("expected a number above from, {}; found {}", values.front(), values.back()));
    }
    return values;
}

}  // namespace

ResponseSettings build_response(const AnalysisTable& table, const BuildContext& context) {
    ResponseSettings settings;
    settings.gravity = table.gravity;
    if (table.gravity) return settings;
    settings.omegas = list_frequencies(table.omega ? *table.omega : *table.frequency, context);
    if (!table.omega) {
        for (double& omega : settings.omegas) omega *= 2.0 * std::numbers::pi;
    }
    return settings;
}

void build_excitation(BuildContext& context) {
    const auto tables = list_analyses(context.deck);
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        auto* response = std::get_if<ResponseSettings>(&context.stages[i].analysis);
        if (response == nullptr) continue;
        for (const ExcitationTable& one : tables[i].get().excite) {
            if (const std::optional<PlacedPoint> point = context.place(one.at.word))
                response->excitation.push_back({point->node, one.force, one.moment, one.phase});
        }
    }
}

void name_response_points(const std::vector<HistoryRequest>& histories, BuildContext& context) {
    const auto tables = list_analyses(context.deck);
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        auto* response = std::get_if<ResponseSettings>(&context.stages[i].analysis);
        if (response == nullptr) continue;
        for (const HistoryRequest& history : histories) {
            const int node = node_of(history.target);
            if (node >= 0) response->points.push_back({history.name, node});
        }
        if (!response->points.empty()) continue;
        const AnalysisTable& table = tables[i];
        context.add_fault(
            table,
            table.kind,
            "a response is recorded where [[history]] names a node; the deck has no such history");
    }
}

}  // namespace gxrod
