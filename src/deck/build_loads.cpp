#include "deck/build_loads.hpp"

#include <algorithm>

#include "deck/choices.hpp"
#include "model/evaluation_error.hpp"

namespace gxrod {
namespace {

constexpr long largest_sample = 10000;

std::array<TimeFunction, 3> functions_of(const CheckedTable& load, const char* key) {
    std::array<TimeFunction, 3> functions;
    if (!load.gives(key)) return functions;
    const auto& components = load.get<CheckedTimeVector>(key);
    for (int i = 0; i < 3; ++i) functions[i] = components[i].function;
    return functions;
}

Quat axes_at(const PlacedPoint& point, const Model& model) {
    if (point.body >= 0) return model.bodies[point.body].attitude;
    return model.rods[point.rod].triad_at(point.position_in_rod);
}

void check_function(const CheckedTimeFunction& value,
                    const DynamicSettings& analysis,
                    const BuildContext& context) {
    if (value.function.is_constant()) return;
    const long samples = std::min(analysis.steps, largest_sample);
    try {
        for (long i = 0; i <= samples; ++i) {
            const long step = i * (analysis.steps / samples) + i * (analysis.steps % samples) / samples;
            value.function(analysis.end_time *
                           (static_cast<double>(step) / static_cast<double>(analysis.steps)));
        }
    } catch (const EvaluationError& error) {
        // The fault names the key itself.
        const std::string what = error.what();
        context.faults.add(value.place, value.path, what.substr(value.path.size() + 2));
    }
}

}  // namespace

void build_loads(BuildContext& context) {
    for (const CheckedTable& table : context.deck.tables("load")) {
        const std::optional<PlacedPoint> point = context.place(table.get<std::string>("at"));
        if (!point) continue;
        context.model.loads.push_back({.key = table.path,
                                       .node = point->node,
                                       .force = functions_of(table, "force"),
                                       .moment = functions_of(table, "moment"),
                                       .frame = value_of(frame_choices, table.get<std::string>("frame")),
                                       .axes = axes_at(*point, context.model)});
    }
}

void check_load_functions(const DynamicSettings& analysis, BuildContext& context) {
    for (const CheckedTable& table : context.deck.tables("load")) {
        for (const char* key : {"force", "moment"}) {
            if (!table.gives(key)) continue;
            for (const CheckedTimeFunction& component : table.get<CheckedTimeVector>(key)) {
                check_function(component, analysis, context);
            }
        }
    }
}

}  // namespace gxrod
