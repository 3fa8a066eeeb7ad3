#include "deck/build/build_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gxrod {
namespace {

// The numbers of a table that has their ends or lists them.
std::vector<double> list_sweep(const CheckedTable& table, const BuildContext& context) {
    std::vector<double> values;
    if (table.gives("values")) {
        values = table.get<std::vector<double>>("values");
        std::sort(values.begin(), values.end());
        if (values.front() < 0.0)
            context.add_fault(table, "values", "expected numbers that are not negative");
        return values;
    }
    const double from = table.get<double>("from"), to = table.get<double>("to");
    const bool is_log = table.get<std::string>("spacing") == "log";
    if (to <= from)
        context.add_fault(table, "to", fmt::format("expected a number above from, {}; found {}", from, to));
    if (is_log && from == 0.0) context.add_fault(table, "from", "equal ratios cannot begin at 0");
    const long count = table.get<long>("count");
    for (long i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count - 1);
        values.push_back(is_log ? from * std::pow(to / from, part) : from + part * (to - from));
    }
    values.back() = to;
    return values;
}

void add_excitation(const CheckedTable& table, const BuildContext& context, ResponseSettings& settings) {
    for (const CheckedTable& one : table.tables("excite")) {
        const std::optional<PlacedPoint> point = context.place(one.get<std::string>("at"));
        if (!point) continue;
        settings.excitation.push_back(
            {point->node, one.get<Vec3>("force"), one.get<Vec3>("moment"), one.get<double>("phase")});
    }
}

}  // namespace

ResponseSettings build_response(const CheckedTable& table, const BuildContext& context) {
    ResponseSettings settings;
    const bool is_omega = table.gives("omega");
    settings.omegas = list_sweep(table.tables(is_omega ? "omega" : "frequency").front(), context);
    if (!is_omega) {
        for (double& omega : settings.omegas) omega *= 2.0 * std::numbers::pi;
    }
    return settings;
}

void build_excitation(BuildContext& context) {
    const auto& listed = context.deck.tables("stage");
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        const CheckedTable& table = listed.empty() ? context.deck.tables("analysis").front() : listed[i];
        auto* response = std::get_if<ResponseSettings>(&context.stages[i].analysis);
        if (response != nullptr) add_excitation(table, context, *response);
    }
}

void name_response_points(const std::vector<HistoryRequest>& histories, std::vector<StagePlan>& stages) {
    for (StagePlan& stage : stages) {
        auto* response = std::get_if<ResponseSettings>(&stage.analysis);
        if (response == nullptr) continue;
        for (const HistoryRequest& history : histories) {
            if (history.node >= 0) response->points.push_back({history.name, history.node});
        }
    }
}

}  // namespace gxrod
