#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "deck/loads/acting.hpp"
#include "deck/loads/combinations.hpp"
#include "deck/loads/loads.hpp"
#include "deck/places/part.hpp"
#include "deck/places/point_patterns.hpp"
#include "deck/reading/copies.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/top_level.hpp"

namespace gxrod {
namespace {

struct LoadTable : ActingTable {
    std::optional<PointPatterns> at;
    std::optional<TableNames> on;
    std::optional<PlaceCondition> where;
    std::optional<CheckedMotionVector> force, moment;
    std::optional<CheckedLineMotionVector> force_per_length, moment_per_length;
    Frame frame = NodalLoad{}.frame;
    Copies copies;
};

}  // namespace

const TableSpec& load_table() {
    using T = LoadTable;
    // clang-format off
    static const TableSpec table = Table<T>("[[load]]", "A force and a moment at a point, or along a rod.")
        .key("at", &T::at, "A point of a rod, or a body, or several; with `where`, rods too. Points that "
             "are one node have the load once.")
            .also("pos position point node location")
        .key("on", &T::on, "The name of a rod, or of several, with * for any letters, for a load along them.")
            .names_of({"rod"}).also("rod beam along")
        .key("where", &T::where, "At which of the points the load acts, or with `on` along which elements, by their "
             "middle, as they are at t = 0; s is the arc length from the rod's start. Comparisons allow for round-off. Without "
             "`at` and `on`, at ends and corners of rods and nodes between elements of meshes.")
            .otherwise("all").also("if filter region box condition")
        .key("force", &T::force, "Force; x, y, z is where the point is then, vx, vy, vz its velocity, rx, ry, rz its rotation vector "
             "since t = 0, wx, wy, wz its angular velocity, all global.")
            .unit("mass·length/time²").otherwise("[0, 0, 0]").also("f value magnitude vector")
        .key("moment", &T::moment, "Moment; of the same variables.")
            .unit("mass·length²/time²").otherwise("[0, 0, 0]").also("m torque couple")
        .key("force_per_length", &T::force_per_length,
             "Force per reference length; s is the arc length from the rod's start, the others are of the point there.")
            .unit("mass/time²").otherwise("[0, 0, 0]")
            .also("q p distributed line_load force_per_unit_length distributed_force")
        .key("moment_per_length", &T::moment_per_length,
             "Moment per reference length; of the same variables.")
            .unit("mass·length/time²").otherwise("[0, 0, 0]")
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
        .with(add_load_case<T>)
        .with(add_copies<T>)
        .at_most_one_of({"at", "on"})
        .at_least_one_of({"at", "on", "where"})
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
            "case  = \"pull\"\n"
            "\n"
            "[[load]]\n"
            "on = \"flyer\"\n"
            "force_per_length = [0, 0, \"-2*push(t)*(1 - s/10)\"]\n");
    // clang-format on
    return table;
}

namespace {

// The parts of a force, or a moment, that depend on the motion.
struct MotionParts {
    std::array<PointFunction, 6> components;  // empty where nothing does
    bool turns = false;

    MotionLoad make_load() const {
        MotionLoad load;
        const auto any = [&](std::size_t first) {
            return components[first] || components[first + 1] || components[first + 2];
        };
        load.has_force = any(0);
        load.has_moment = any(3);
        load.turns = turns;
        if (!load.has_force && !load.has_moment) return load;
        load.value = [all = components](double time, double s, const PointMotion& motion) {
            Vec6 value = Vec6::Zero();
            for (std::size_t i = 0; i < 6; ++i) {
                if (all[i]) value[static_cast<Eigen::Index>(i)] = all[i](time, s, motion);
            }
            return value;
        };
        return load;
    }
};

TimeFunction rest_of(const CheckedMotionFunction& value, const Acting& acting) {
    return acting.apply(value.expression.by_time);
}

bool has_time(const CheckedMotionFunction& value) { return value.expression.has_time; }

LineFunction rest_of(const CheckedLineMotionFunction& value, const Acting& acting) {
    return acting.apply(value.expression.by_line);
}

bool has_time(const CheckedLineMotionFunction& value) { return value.expression.by_line.has_time; }

// Three functions without the motion; what depends on it goes to `parts`, from `first` on.
template <class Function, class Checked>
std::array<Function, 3> split(const std::optional<std::array<Checked, 3>>& components,
                              const Acting& acting,
                              std::size_t first,
                              MotionParts& parts) {
    std::array<Function, 3> functions;
    for (std::size_t i = 0; components && i < 3; ++i) {
        const Checked& one = (*components)[i];
        if (!one.expression.by_motion) {
            functions[i] = rest_of(one, acting);
            continue;
        }
        parts.components[first + i] = acting.apply(one.expression.by_motion, has_time(one));
        parts.turns = parts.turns || one.expression.turns;
    }
    return functions;
}

void add_nodal_load(const LoadTable& given,
                    const PlacedPoint& point,
                    const Acting& acting,
                    BuildContext& context) {
    MotionParts parts;
    NodalLoad load{.key = given.path,
                   .node = point.node,
                   .force = split<TimeFunction>(given.force, acting, 0, parts),
                   .moment = split<TimeFunction>(given.moment, acting, 3, parts),
                   .frame = given.frame,
                   .axes = context.axes_at(point)};
    load.by_motion = parts.make_load();
    context.model.loads.push_back(std::move(load));
}

// The elements of a rod that satisfy a condition.
class LoadedPart {
  public:
    LoadedPart(const Rod& rod, std::vector<bool> selected) : selected_(std::move(selected)) {
        const auto nodes = static_cast<std::size_t>(rod.order) + 1;
        for (std::size_t last = nodes - 1; last < rod.arc_length.size(); last += nodes)
            ends_.push_back(rod.arc_length[last]);
    }

    bool is_empty() const { return std::ranges::find(selected_, true) == selected_.end(); }
    double at(double s) const {
        const auto element = std::ranges::lower_bound(ends_, s) - ends_.begin();
        return selected_[std::min(static_cast<std::size_t>(element), ends_.size() - 1)] ? 1.0 : 0.0;
    }

  private:
    std::vector<double> ends_;  // arc lengths where elements end
    std::vector<bool> selected_;
};

void restrict(const std::shared_ptr<const LoadedPart>& part, DistributedLoad& load) {
    for (auto* functions : {&load.force, &load.moment}) {
        for (LineFunction& one : *functions) {
            if (one.is_zero()) continue;
            const LineForm form{one.is_constant() ? InTime::constant : one.form().in_time, false};
            one = LineFunction(
                [part, one](double t, double s) { return part->at(s) * one(t, s); }, one.switches(), form);
        }
    }
    if (!load.by_motion.value) return;
    load.by_motion.value = [part, all = load.by_motion.value](double t, double s, const PointMotion& motion) {
        return Vec6(part->at(s) * all(t, s, motion));
    };
}

// Adds the load along a rod; returns whether `where` leaves elements of it.
bool add_distributed_load(const LoadTable& given, int rod, const Acting& acting, BuildContext& context) {
    std::shared_ptr<const LoadedPart> loaded;
    if (given.where) {
        const Rod& of = context.model.rods[static_cast<std::size_t>(rod)];
        loaded = std::make_shared<LoadedPart>(of, select_elements(of, *given.where, context));
        if (loaded->is_empty()) return false;
    }
    MotionParts parts;
    DistributedLoad load{.key = given.path,
                         .rod = rod,
                         .force = split<LineFunction>(given.force_per_length, acting, 0, parts),
                         .moment = split<LineFunction>(given.moment_per_length, acting, 3, parts),
                         .frame = given.frame};
    load.by_motion = parts.make_load();
    if (loaded) restrict(loaded, load);
    context.model.distributed_loads.push_back(std::move(load));
    return true;
}

void add_distributed_loads(const LoadTable& given, const Acting& acting, BuildContext& context) {
    std::vector<int> rods;
    if (given.on) {
        for (const Part& part : find_parts(given, *given.on, context)) rods.push_back(part.rod);
    } else {
        rods = context.names.find_rods("*");
    }
    bool is_any = rods.empty();
    for (const int rod : rods) is_any = add_distributed_load(given, rod, acting, context) || is_any;
    if (!is_any)
        context.add_fault(
            given,
            given.where,
            fmt::format("no element of the rods here has its middle where \"{}\" holds", given.where->text));
}

// Faults of keys that go with `at` in a table that has `on`, and the reverse.
void check_companions(const LoadTable& given, const BuildContext& context) {
    const auto refuse = [&](const auto& field, const char* with, const char* has, const char* others) {
        if (!field) return;
        context.add_fault(
            given,
            field,
            fmt::format("goes with {}, and this table has {}, with which go {}", with, has, others));
    };
    constexpr const char* along = "force_per_length, moment_per_length";
    if (given.on && !given.at) {
        refuse(given.force, "at", "on", along);
        refuse(given.moment, "at", "on", along);
    }
    if (given.at && !given.on) {
        refuse(given.force_per_length, "on", "at", "force, moment");
        refuse(given.moment_per_length, "on", "at", "force, moment");
    }
}

// Adds what a table says, at points or along rods.
void add_load(const LoadTable& given, const Acting& acting, BuildContext& context) {
    const bool has_points = given.force || given.moment;
    const bool is_along = given.force_per_length || given.moment_per_length;
    if (!has_points && !is_along)
        return context.add_fault(
            given,
            given.where,
            "nothing acts there; expected force or moment, or force_per_length or moment_per_length");
    if (given.at || (has_points && !given.on)) {
        for (const PlacedPoint& point : find_points(given, given.at, given.where, context))
            add_nodal_load(given, point, acting, context);
    }
    if (given.on || (is_along && !given.at)) add_distributed_loads(given, acting, context);
}

bool is_fixed_in_space(const LoadTable& given) {
    return given.at && !given.where && given.force && given.frame == Frame::spatial &&
           std::ranges::none_of(*given.force, [](const CheckedMotionFunction& one) {
               return static_cast<bool>(one.expression.by_motion);
           });
}

}  // namespace

std::vector<SteadyLoad> list_steady_loads(const BuildContext& context) {
    const double time = is_timed(context.stages.front().analysis) ? 0.0 : 1.0;
    std::vector<SteadyLoad> loads;
    for (const LoadTable& given : tables_of<LoadTable>(context.deck, load_table())) {
        const Acting acting = find_acting(given, context);
        if (acting.is_absent || !is_fixed_in_space(given)) continue;
        Vec3 force;
        for (int i = 0; i < 3; ++i)
            force[i] = rest_of((*given.force)[static_cast<std::size_t>(i)], acting)(time);
        for (const CheckedWord& word : given.at->words) {
            const auto found = context.names.find_all(word.word);
            const auto* points = std::get_if<std::vector<NamedPoint>>(&found);
            if (points == nullptr) continue;
            for (const NamedPoint& one : *points) loads.push_back({one.text, force});
        }
    }
    return loads;
}

void build_loads(BuildContext& context) {
    if (const CheckedTimeVector* gravity = find_gravity(context.deck)) {
        Acting acting = find_gravity_acting(context);
        acting.scale = find_gravity_factor(context);
        std::array<TimeFunction, 3> components;
        for (std::size_t i = 0; i < 3; ++i) components[i] = acting.apply((*gravity)[i].function);
        context.model.gravity = TimeVector(std::move(components));
    }
    for (const LoadTable& given : tables_of<LoadTable>(context.deck, load_table())) {
        if (context.stage == 0) check_companions(given, context);
        const Acting acting = find_acting(given, context);
        if (acting.is_absent) continue;
        add_load(given, acting, context);
    }
}

}  // namespace gxrod
