#include "deck/analyses/build_path.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/schema/choices.hpp"

namespace gxrod {
namespace {

void read_load_bounds(const CheckedTable& until, const BuildContext& context, PathSettings& settings) {
    const auto& bounds = until.get<std::vector<double>>("t");
    const bool is_pair = bounds.size() == 2;
    if (is_pair && (bounds[0] > 0.0 || bounds[1] <= 0.0)) {
        context.add_fault(
            until,
            "t",
            fmt::format(
                "a path begins at t = 0 and goes up first; the bounds are {} and {}", bounds[0], bounds[1]));
    }
    if (!is_pair && bounds[0] == 0.0)
        context.add_fault(until, "t", "a path begins at t = 0, so that it cannot end there at once");
    if (is_pair || bounds[0] < 0.0) settings.least_load = bounds[0];
    if (is_pair || bounds[0] > 0.0) settings.greatest_load = bounds.back();
}

// Once points have nodes.
PathTarget build_target(const CheckedTable& table, const BuildContext& context) {
    PathTarget target;
    if (!table.gives("of")) {
        target.values = table.get<std::vector<double>>("t");
        return target;
    }
    const std::optional<PlacedPoint> point = context.place(table.get<std::string>("of"));
    if (!point) return target;
    target.node = point->node;
    target.component = value_of(direction_choices, table.get<std::string>("displacement"));
    target.values = table.get<std::vector<double>>("values");
    return target;
}

bool is_held(int node, int component, const Model& model, const std::vector<Support>& supports) {
    if (node < 0) return false;
    if (model.plane && model.plane->holds(component)) return true;
    const int first = component < 3 ? 0 : 3;
    return std::any_of(supports.begin(), supports.end(), [&](const Support& support) {
        if (support.node != node) return false;
        // In oblique axes, what stays free of a component is not the component.
        for (int i = 0; i < 3; ++i) {
            if (support.holds(first + i) && support.axes.toRotationMatrix()(component - first, i) != 0.0)
                return true;
        }
        return false;
    });
}

// Once points have nodes.
PathControl build_control(const CheckedTable& table, const BuildContext& context) {
    PathControl control;
    if (const std::optional<PlacedPoint> point = context.place(table.get<std::string>("of")))
        control.node = point->node;
    const bool turns = table.gives("rotation");
    const std::string& direction = table.get<std::string>(turns ? "rotation" : "displacement");
    control.component = value_of(direction_choices, direction) + (turns ? 3 : 0);
    if (table.gives("to")) control.to = table.get<double>("to");
    return control;
}

}  // namespace

PathSettings build_path(const CheckedTable& table, const BuildContext& context) {
    PathSettings settings;
    const CheckedTable& until = table.tables("until").front();
    if (until.gives("t")) read_load_bounds(until, context, settings);
    if (until.gives("arc")) settings.arc = until.get<double>("arc");
    if (until.gives("steps")) settings.steps = until.get<long>("steps");
    if (until.gives("points")) settings.points = until.get<long>("points");
    if (table.gives("step")) settings.first_step = table.get<double>("step");
    settings.max_step = table.get<double>("max_step");
    settings.min_step = table.get<double>("min_step");
    settings.critical = value_of(critical_search_choices, table.get<std::string>("critical"));
    settings.branches = static_cast<int>(table.get<long>("branches"));
    for (const char* key : {"step", "max_step"}) {
        if (!table.find(key) || table.get<double>(key) >= settings.min_step) continue;
        context.add_fault(table,
                          key,
                          fmt::format("expected a number not below min_step, {}; found {}",
                                      settings.min_step,
                                      table.get<double>(key)));
    }
    if (settings.branches > 0 && settings.critical != CriticalSearch::locate) {
        context.add_fault(
            table, "branches", "branches leave bifurcations, which critical = \"locate\" finds");
    }
    if (table.gives("follow") && settings.branches > 0)
        context.add_fault(table, "branches", "a stage that follows limit points has no branches");
    if (table.gives("follow") && table.gives("control"))
        context.add_fault(table, "control", "a stage that follows limit points goes by its arc length");
    return settings;
}

void build_follow(const CheckedTable& table, std::span<StagePlan> stages, const BuildContext& context) {
    auto* path = std::get_if<PathSettings>(&stages.back().analysis);
    if (path == nullptr || !table.gives("follow")) return;
    const std::span<StagePlan> earlier = stages.first(stages.size() - 1);
    const auto before = std::find_if(
        earlier.rbegin(), earlier.rend(), [](const StagePlan& stage) { return has_steps(stage.analysis); });
    const auto* ended = before == earlier.rend() ? nullptr : std::get_if<PathSettings>(&before->analysis);
    if (ended == nullptr || ended->limit_load_factor)
        return context.add_fault(
            table, "follow", "the stage before must be a path, which ends on the limit point to follow");
    path->limit_load_factor = before->end;
}

void build_path_targets(BuildContext& context) {
    const auto& listed = context.deck.tables("stage");
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        StagePlan& stage = context.stages[i];
        const CheckedTable& table = listed.empty() ? context.deck.tables("analysis").front() : listed[i];
        auto* path = std::get_if<PathSettings>(&stage.analysis);
        if (path == nullptr) continue;
        const std::vector<Support>& supports = i == 0 ? context.model.supports : stage.actions.supports;
        for (const CheckedTable& one : table.tables("at")) {
            path->at.push_back(build_target(one, context));
            if (is_held(path->at.back().node, path->at.back().component, context.model, supports))
                context.add_fault(one, "displacement", "a support holds it");
        }
        for (const CheckedTable& one : table.tables("control")) {
            const PathControl control = build_control(one, context);
            if (control.node >= 0) path->control = control;
            if (is_held(control.node, control.component, context.model, supports))
                context.add_fault(
                    one, control.component < 3 ? "displacement" : "rotation", "a support holds it");
        }
    }
}

}  // namespace gxrod
