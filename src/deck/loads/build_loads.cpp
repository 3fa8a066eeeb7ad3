#include "deck/loads/build_loads.hpp"

#include "deck/loads/acting.hpp"
#include "deck/places/part.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

// What the model has for a value of the deck.
TimeFunction function_of(const CheckedTimeFunction& value, const Acting& acting) {
    return acting.apply(value.function);
}

LineFunction function_of(const CheckedLineFunction& value, const Acting& acting) {
    return acting.apply(value.expression);
}

// Three functions of a key; zero if it is not given.
template <class Function, class Checked>
std::array<Function, 3> functions_of(const CheckedTable& table, const char* key, const Acting& acting) {
    std::array<Function, 3> functions;
    if (!table.gives(key)) return functions;
    const auto& components = table.get<std::array<Checked, 3>>(key);
    for (std::size_t i = 0; i < 3; ++i) functions[i] = function_of(components[i], acting);
    return functions;
}

void set_force(const CheckedMotionVector& components, const Acting& acting, NodalLoad& load) {
    std::array<MotionComponent, 3> by_motion;
    for (std::size_t i = 0; i < 3; ++i) {
        const MotionExpression& component = components[i].expression;
        if (component.by_motion) {
            by_motion[i] = acting.apply(component);
        } else {
            load.force[i] = acting.apply(component.by_time);
        }
    }
    if (!by_motion[0] && !by_motion[1] && !by_motion[2]) return;
    load.motion_force = [by_motion](double time, const Vec3& position, const Vec3& velocity) {
        Vec3 force = Vec3::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            if (by_motion[i]) force[static_cast<Eigen::Index>(i)] = by_motion[i](time, position, velocity);
        }
        return force;
    };
}

void add_nodal_load(const CheckedTable& table, Frame frame, const Acting& acting, BuildContext& context) {
    const std::optional<PlacedPoint> point = context.place(table.get<std::string>("at"));
    if (!point) return;
    const auto vector = [&](const char* key) {
        return functions_of<TimeFunction, CheckedTimeFunction>(table, key, acting);
    };
    NodalLoad load{.key = table.path,
                   .node = point->node,
                   .force = {},
                   .moment = vector("moment"),
                   .frame = frame,
                   .axes = context.axes_at(*point)};
    if (table.gives("force")) set_force(table.get<CheckedMotionVector>("force"), acting, load);
    context.model.loads.push_back(std::move(load));
}

void add_distributed_load(const CheckedTable& table,
                          Frame frame,
                          const Acting& acting,
                          BuildContext& context) {
    const std::optional<Part> part = find_part(table, *load_table().find("on"), context);
    if (!part) return;
    const auto vector = [&](const char* key) {
        return functions_of<LineFunction, CheckedLineFunction>(table, key, acting);
    };
    context.model.distributed_loads.push_back({.key = table.path,
                                               .rod = part->rod,
                                               .force = vector("force_per_length"),
                                               .moment = vector("moment_per_length"),
                                               .frame = frame});
}

void build_rotation(BuildContext& context) {
    const std::vector<CheckedTable>& tables = context.deck.tables("rotation");
    if (tables.empty()) return;
    const CheckedTable& table = tables.front();
    const Vec3 axis = table.get<Vec3>("axis");
    if (axis.norm() == 0.0) return context.add_fault(table, "axis", "expected a vector that is not zero");
    const auto& speed = table.get<CheckedTimeFunction>("speed");
    context.model.rotation = TurningFrame{
        axis.normalized(), table.get<Vec3>("through"), find_acting(context).apply(speed.function)};
}

}  // namespace

void build_loads(BuildContext& context) {
    context.model.gravity = TimeVector(
        functions_of<TimeFunction, CheckedTimeFunction>(context.deck, "gravity", find_acting(context)));
    build_rotation(context);
    for (const CheckedTable& table : context.deck.tables("load")) {
        const Acting acting = find_acting(table, context);
        if (acting.is_absent) continue;
        const Frame frame = value_of(frame_choices, table.get<std::string>("frame"));
        if (table.gives("at")) {
            add_nodal_load(table, frame, acting, context);
        } else {
            add_distributed_load(table, frame, acting, context);
        }
    }
}

}  // namespace gxrod
