#include "deck/analyses/build_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "deck/output/listed_values.hpp"

namespace gxrod {
namespace {

// Rising.
std::vector<double> list_frequencies(const CheckedTable& table, const BuildContext& context) {
    std::vector<double> values = list_values(table, context);
    if (table.gives("values")) {
        std::sort(values.begin(), values.end());
        if (values.front() < 0.0)
            context.add_fault(table, "values", "expected numbers that are not negative");
    } else if (values.back() < values.front()) {
        context.add_fault(
            table,
            "to",
            fmt::format("expected a number above from, {}; found {}", values.front(), values.back()));
    }
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
    settings.omegas = list_frequencies(table.tables(is_omega ? "omega" : "frequency").front(), context);
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

void name_response_points(const std::vector<HistoryRequest>& histories, BuildContext& context) {
    const auto& listed = context.deck.tables("stage");
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        auto* response = std::get_if<ResponseSettings>(&context.stages[i].analysis);
        if (response == nullptr) continue;
        for (const HistoryRequest& history : histories) {
            const int node = node_of(history.target);
            if (node >= 0) response->points.push_back({history.name, node});
        }
        if (!response->points.empty()) continue;
        context.add_fault(
            listed.empty() ? context.deck.tables("analysis").front() : listed[i],
            "kind",
            "a response is recorded where [[history]] names a node; the deck has no such history");
    }
}

}  // namespace gxrod
