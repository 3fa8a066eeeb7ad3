#include "deck/loads/acting.hpp"
#include "deck/loads/loads.hpp"
#include "deck/places/part.hpp"
#include "deck/reading/copies.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/top_level.hpp"

namespace gxrod {
namespace {

struct LoadTable : ActingTable {
    std::optional<PointName> at;
    std::optional<TableName> on;
    std::optional<CheckedMotionVector> force;
    std::optional<CheckedTimeVector> moment;
    std::optional<CheckedLineVector> force_per_length, moment_per_length;
    Frame frame = NodalLoad{}.frame;
    Copies copies;
};

}  // namespace

const TableSpec& load_table() {
    using T = LoadTable;
    // clang-format off
    static const TableSpec table = Table<T>("[[load]]", "A force and a moment at a point, or along a rod.")
        .key("at", &T::at, "A point of a rod, or a body.")
            .also("pos position point node location where")
        .key("on", &T::on, "The name of a rod, for a load along it.")
            .names_of({"rod"}).also("rod beam along")
        .key("force", &T::force, "Force; x, y, z is where the point is then, vx, vy, vz how fast it moves, global.")
            .unit("mass·length/time²").otherwise("[0, 0, 0]").only_with("at").also("f value magnitude vector")
        .key("moment", &T::moment, "Moment.")
            .unit("mass·length²/time²").otherwise("[0, 0, 0]").only_with("at").also("m torque couple")
        .key("force_per_length", &T::force_per_length,
             "Force per reference length; s is the arc length from the rod's start.")
            .unit("mass/time²").otherwise("[0, 0, 0]").only_with("on")
            .also("q p distributed line_load force_per_unit_length distributed_force")
        .key("moment_per_length", &T::moment_per_length,
             "Moment per reference length; s is the arc length from the rod's start.")
            .unit("mass·length/time²").otherwise("[0, 0, 0]").only_with("on")
        .key("frame", &T::frame, "spatial: fixed in space, a dead load. follower: global components at t = 0, turned "
             "with the node or section. body: components in the section axes of the point named, or along the rod "
             "(body axes of a body).")
            .also("type follower direction")
        .key("factor", &T::factor, factor_sentence("load"))
            .unit("1").otherwise(factor_default)
        .key("relative_to", &T::relative_to, "limit: for a stage with `follow`, where it begins to act: the load is "
             "its value times the load factor of the limit point, and without t times t.")
            .otherwise("nothing")
        .key("stages", &T::stages, "The stages in which the load acts.")
            .otherwise("all").names_of({"stage"})
        .with(add_copies<T>)
        .exactly_one_of({"at", "on"})
        .at_least_one_of({"force", "moment"}, "at")
        .at_least_one_of({"force_per_length", "moment_per_length"}, "on")
        .shown_by(
            "[[load]]\n"
            "at     = \"flyer.start\"\n"
            "force  = [\"pulse(t)/10\", 0, 0]\n"
            "moment = [0, \"-pulse(t)/2\", \"-pulse(t)\"]\n"
            "\n"
            "[[load]]\n"
            "at    = \"flyer@0.25\"\n"
            "force = [0, 0, \"push(t)\"]\n"
            "frame = \"follower\"\n"
            "\n"
            "[[load]]\n"
            "on = \"flyer\"\n"
            "force_per_length = [0, 0, \"-2*push(t)*(1 - s/10)\"]\n");
    // clang-format on
    return table;
}

namespace {

// What the model has for a value of the deck.
TimeFunction function_of(const CheckedTimeFunction& value, const Acting& acting) {
    return acting.apply(value.function);
}

LineFunction function_of(const CheckedLineFunction& value, const Acting& acting) {
    return acting.apply(value.expression);
}

// Three functions; zero if the deck does not give them.
template <class Function, class Checked>
std::array<Function, 3> functions_of(const std::optional<std::array<Checked, 3>>& components,
                                     const Acting& acting) {
    std::array<Function, 3> functions;
    if (!components) return functions;
    for (std::size_t i = 0; i < 3; ++i) functions[i] = function_of((*components)[i], acting);
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

void add_nodal_load(const LoadTable& given, const Acting& acting, BuildContext& context) {
    const std::optional<PlacedPoint> point = context.place(given.at->word);
    if (!point) return;
    NodalLoad load{.key = given.path,
                   .node = point->node,
                   .force = {},
                   .moment = functions_of<TimeFunction>(given.moment, acting),
                   .frame = given.frame,
                   .axes = context.axes_at(*point)};
    if (given.force) set_force(*given.force, acting, load);
    context.model.loads.push_back(std::move(load));
}

void add_distributed_load(const LoadTable& given, const Acting& acting, BuildContext& context) {
    const std::optional<Part> part = find_part(given, *given.on, context);
    if (!part) return;
    context.model.distributed_loads.push_back(
        {.key = given.path,
         .rod = part->rod,
         .force = functions_of<LineFunction>(given.force_per_length, acting),
         .moment = functions_of<LineFunction>(given.moment_per_length, acting),
         .frame = given.frame});
}

}  // namespace

void build_loads(BuildContext& context) {
    if (const auto& gravity = top_level_of(context.deck).gravity)
        context.model.gravity = TimeVector(functions_of<TimeFunction>(gravity, find_acting(context)));
    for (const LoadTable& given : tables_of<LoadTable>(context.deck, load_table())) {
        const Acting acting = find_acting(given, context);
        if (acting.is_absent) continue;
        if (given.at) {
            add_nodal_load(given, acting, context);
        } else {
            add_distributed_load(given, acting, context);
        }
    }
}

}  // namespace gxrod
