#include "deck/analyses/build_path.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/analyses/analysis_table.hpp"
#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

constexpr double most_of_a_path = static_cast<double>(largest_step_count);

const TableSpec& until_table() {
    using T = UntilTable;
    // clang-format off
    static const TableSpec table = Table<T>("analysis.until", "")
        .key("t", &T::t, "The load factor at which it ends: one bound, to which t goes from 0, or `[lower, upper]`, of "
             "which t goes to the upper one first.")
            .unit("1")
        .key("arc", &T::arc, "The arc length at which it ends.")
            .unit("1").above(0)
        .key("steps", &T::steps, "The accepted steps after which it ends.")
            .between(1, most_of_a_path)
        .key("points", &T::points, "The limit points and bifurcations after which it ends.")
            .between(1, most_of_a_path)
        .at_least_one_of({"t", "arc", "steps", "points"});
    // clang-format on
    return table;
}

const TableSpec& path_target_table() {
    using T = PathTargetTable;
    // clang-format off
    static const TableSpec table = Table<T>("analysis.at[]", "")
        .key("of", &T::of, "The point whose displacement has the values.")
        .key("displacement", &T::displacement, "The component, in global axes.")
            .required().only_with("of")
        .key("values", &T::values, "Of the displacement.")
            .unit("length").required().only_with("of")
        .key("t", &T::t, "Values of the load factor, instead.")
            .unit("1")
        .exactly_one_of({"of", "t"});
    // clang-format on
    return table;
}

const TableSpec& path_control_table() {
    using T = PathControlTable;
    // clang-format off
    static const TableSpec table = Table<T>("analysis.control", "")
        .key("of", &T::of, "The point that moves.")
            .required()
        .key("displacement", &T::displacement, "Its component that each step prescribes, in global axes.")
            .otherwise("`rotation`")
        .key("rotation", &T::rotation, "Instead, the component of the rotation in the step.")
            .otherwise("`displacement`")
        .key("to", &T::to,
             "The displacement at which the path ends; it sets out to there, whether t grows or falls.")
            .unit("length").only_with("displacement")
        .exactly_one_of({"displacement", "rotation"});
    // clang-format on
    return table;
}

}  // namespace

void add_path_keys(Table<AnalysisTable>& table) {
    using T = AnalysisTable;
    const Condition path_only{"kind", {"path"}};
    // clang-format off
    table
        .key("until", &T::until, until_table(), "Where the path ends, and each of its branches: whichever comes first.")
            .required().only_for({path_only}).may_change()
        .key("step", &T::step,
             "The first arc length: about the mean displacement over the model's length, or the mean rotation in rad "
             "times 0.2. Later steps are longer or shorter as Newton's method needs few or many iterations.")
            .unit("1").above(0).otherwise("by how the model answers to its loads").only_for({path_only}).may_change()
        .key("max_step", &T::max_step, "No step is longer: long ones can pass over a branch or get on to another one.")
            .unit("1").above(0).only_for({path_only}).may_change()
        .key("min_step", &T::min_step, "A path that needs a shorter step fails. With contact 1e-7 stands for 1e-10.")
            .unit("1").above(0).only_for({path_only}).may_change()
        .key("at", &T::at, path_target_table(),
             "Displacements and load factors at which the path has an equilibrium, exactly, with a frame, as often as "
             "it passes them.")
            .only_for({path_only}).may_change()
        .key("control", &T::control, path_control_table(),
             "Steps prescribe a displacement instead of the arc length. The path fails where that turns back.")
            .only_for({path_only})
        .key("critical", &T::critical,
             "locate: steps end on limit points and bifurcations, whose shapes are found, and where contact begins "
             "and ends. report: the steps within which they lie are named. off: they are ignored.")
            .only_for({path_only}).may_change()
        .key("branches", &T::branches,
             "0: the main path only. 1: also the branches that leave it at simple bifurcations, to both sides. 2: "
             "also those that leave these, and so on. Needs critical `locate`.")
            .between(0, 100).only_for({path_only}).may_change()
        .key("follow", &T::follow,
             "limit: the stage before, a path, ended on a limit point, whose load factor is free in this stage: the "
             "limit point is followed while t, the parameter, grows from 0.")
            .otherwise("no limit points").only_for({path_only});
    // clang-format on
}

namespace {

void read_load_bounds(const UntilTable& until, const BuildContext& context, PathSettings& settings) {
    const std::vector<double>& bounds = until.t->numbers;
    const bool is_pair = bounds.size() == 2;
    if (is_pair && (bounds[0] > 0.0 || bounds[1] <= 0.0)) {
        context.add_fault(
            until,
            until.t,
            fmt::format(
                "a path begins at t = 0 and goes up first; the bounds are {} and {}", bounds[0], bounds[1]));
    }
    if (!is_pair && bounds[0] == 0.0)
        context.add_fault(until, until.t, "a path begins at t = 0, so that it cannot end there at once");
    if (is_pair || bounds[0] < 0.0) settings.least_load = bounds[0];
    if (is_pair || bounds[0] > 0.0) settings.greatest_load = bounds.back();
}

// Once points have nodes.
PathTarget build_target(const PathTargetTable& table, const BuildContext& context) {
    if (table.t) return {-1, 0, *table.t};
    const std::optional<PlacedPoint> point = context.place(table.of->word);
    if (!point) return {};
    return {point->node, static_cast<int>(table.displacement), table.values};
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
PathControl build_control(const PathControlTable& table, const BuildContext& context) {
    PathControl control;
    control.to = table.to;
    if (const std::optional<PlacedPoint> point = context.place(table.of.word)) control.node = point->node;
    control.component =
        table.rotation ? 3 + static_cast<int>(*table.rotation) : static_cast<int>(*table.displacement);
    return control;
}

}  // namespace

PathSettings build_path(const AnalysisTable& table, const BuildContext& context) {
    PathSettings settings;
    settings.arc = table.until->arc;
    settings.steps = table.until->steps;
    settings.points = table.until->points;
    settings.first_step = table.step;
    settings.max_step = table.max_step;
    settings.min_step = table.min_step;
    settings.critical = table.critical;
    settings.branches = static_cast<int>(table.branches);
    if (table.until->t) read_load_bounds(*table.until, context, settings);
    const auto check_step = [&](const auto& field, double step) {
        if (step >= table.min_step) return;
        context.add_fault(
            table,
            field,
            fmt::format("expected a number not below min_step, {}; found {}", table.min_step, step));
    };
    if (table.step) check_step(table.step, *table.step);
    check_step(table.max_step, table.max_step);
    if (table.branches > 0 && table.critical != CriticalSearch::locate) {
        context.add_fault(
            table, table.branches, "branches leave bifurcations, which critical = \"locate\" finds");
    }
    if (table.follow && table.branches > 0)
        context.add_fault(table, table.branches, "a stage that follows limit points has no branches");
    if (table.follow && table.control)
        context.add_fault(table, table.control, "a stage that follows limit points goes by its arc length");
    return settings;
}

void build_follow(const AnalysisTable& table, std::span<StagePlan> stages, const BuildContext& context) {
    auto* path = std::get_if<PathSettings>(&stages.back().analysis);
    if (path == nullptr || !table.follow) return;
    const std::span<StagePlan> earlier = stages.first(stages.size() - 1);
    const auto before = std::find_if(
        earlier.rbegin(), earlier.rend(), [](const StagePlan& stage) { return has_steps(stage.analysis); });
    const auto* ended = before == earlier.rend() ? nullptr : std::get_if<PathSettings>(&before->analysis);
    if (ended == nullptr || ended->limit_load_factor)
        return context.add_fault(
            table, table.follow, "the stage before must be a path, which ends on the limit point to follow");
    path->limit_load_factor = before->end;
}

void build_path_targets(BuildContext& context) {
    const auto tables = list_analyses(context.deck);
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        StagePlan& stage = context.stages[i];
        const AnalysisTable& table = tables[i];
        auto* path = std::get_if<PathSettings>(&stage.analysis);
        if (path == nullptr) continue;
        const std::vector<Support>& supports = i == 0 ? context.model.supports : stage.actions.supports;
        for (const PathTargetTable& one : table.at) {
            path->at.push_back(build_target(one, context));
            if (is_held(path->at.back().node, path->at.back().component, context.model, supports))
                context.add_fault(one, one.displacement, "a support holds it");
        }
        if (!table.control) continue;
        const PathControl control = build_control(*table.control, context);
        if (control.node >= 0) path->control = control;
        if (!is_held(control.node, control.component, context.model, supports)) continue;
        const auto& held = control.component < 3 ? table.control->displacement : table.control->rotation;
        context.add_fault(*table.control, held, "a support holds it");
    }
}

}  // namespace gxrod
