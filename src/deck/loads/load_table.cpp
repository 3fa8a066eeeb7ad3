#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "deck/loads/acting.hpp"
#include "deck/loads/combinations.hpp"
#include "deck/loads/loads.hpp"
#include "deck/output/history_table.hpp"
#include "deck/places/part.hpp"
#include "deck/places/point_patterns.hpp"
#include "deck/reading/copies.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/top_level.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

// The columns of a file that has one for each component and station, by name with * for the station's number.
struct LoadColumnsTable : TableHead {
    std::optional<std::string> fx, fy, fz, mx, my, mz;
};

struct LoadTable : ActingTable {
    std::optional<PointPatterns> at;
    std::optional<TableNames> on;
    std::optional<PlaceCondition> where;
    std::optional<CheckedMotionVector> force, moment;
    std::optional<CheckedLineMotionVector> force_per_length, moment_per_length;
    std::optional<std::string> file;
    std::optional<LoadColumnsTable> columns;
    std::optional<std::vector<double>> stations;
    HistoryAxes axes = HistoryAxes::section;
    Frame frame = NodalLoad{}.frame;
    Copies copies;
};

const TableSpec& load_columns_table() {
    using T = LoadColumnsTable;
    // clang-format off
    static const TableSpec table = Table<T>("load.columns", "")
        .key("fx", &T::fx, "Force along x per length: a name like \"AB1N*Fx\", with * for the number of the station; -AB1N*Fx is "
             "the opposite.")
        .key("fy", &T::fy, "Force along y.")
        .key("fz", &T::fz, "Force along z.")
        .key("mx", &T::mx, "Moment about x per length.")
        .key("my", &T::my, "Moment about y.")
        .key("mz", &T::mz, "Moment about z.");
    // clang-format on
    return table;
}

// Loads of a file.
void add_station_keys(Table<LoadTable>& table) {
    using T = LoadTable;
    // clang-format off
    table
        .key("file", &T::file, "In place of values, a file with loads per length at stations, linear between stations and "
             "times; outside of them the nearest ones act. CSV with columns t, s, fx, fy, fz, mx, my, mz, of which s is required, "
             "a row for each time and station; or, with `columns`, one row for each time: CSV, or the output of OpenFAST, .out or .outb.")
        .key("columns", &T::columns, load_columns_table(), "The columns of each component, if the file has one for each station. The "
             "first column of the file is the time.")
            .only_with("file")
        .key("stations", &T::stations, "Arc lengths of the stations from the rod's start, in the order of their numbers.")
            .unit("length").only_with("columns").also("span")
        .key("axes", &T::axes, "With a file and frame `body`: the section axes, or untwisted, those axes turned back by the twist.")
            .only_with("file");
    // clang-format on
}

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
        .with(add_station_keys)
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
        .at_least_one_of({"force_per_length", "moment_per_length", "file"}, "on")
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

// The twist of the sections of a rod, as the deck gives it; of a mesh none.
SectionTwists find_twists(int rod, const BuildContext& context) {
    const auto index = static_cast<std::size_t>(rod);
    SectionTwists found{.arc_lengths = context.rod_fractions[index], .twists = context.rod_twists[index]};
    if (found.arc_lengths.size() != found.twists.size()) return {};
    const std::vector<double>& along = context.model.rods[index].arc_length;
    for (double& fraction : found.arc_lengths) fraction *= along.empty() ? 0.0 : along.back();
    return found;
}

// Sets force and moment from a file, with what they are multiplied by.
void take_file(const LoadTable& given,
               const std::shared_ptr<const StationLoads>& loads,
               const Acting& acting,
               DistributedLoad& load,
               const BuildContext& context) {
    SectionTwists twists;
    if (given.axes == HistoryAxes::untwisted) twists = find_twists(load.rod, context);
    for (const std::size_t first : {std::size_t{0}, std::size_t{3}}) {
        std::array<LineFunction, 3> own = make_load_functions(loads, first, twists);
        for (LineFunction& one : own) one = acting.apply(LineExpression{one, loads->has_time()});
        (first == 0 ? load.force : load.moment) = own;
    }
}

// Adds the load along a rod; returns whether `where` leaves elements of it.
bool add_distributed_load(
    const LoadTable& given, int rod, const Acting& acting, const LoadFiles& files, BuildContext& context) {
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
    if (const auto found = files.find(given.path); found != files.end())
        take_file(given, found->second, acting, load, context);
    if (loaded) restrict(loaded, load);
    context.model.distributed_loads.push_back(std::move(load));
    return true;
}

void add_distributed_loads(const LoadTable& given,
                           const Acting& acting,
                           const LoadFiles& files,
                           BuildContext& context) {
    std::vector<int> rods;
    if (given.on) {
        for (const Part& part : find_parts(given, *given.on, context)) rods.push_back(part.rod);
    } else {
        rods = context.names.find_rods("*");
    }
    bool is_any = rods.empty();
    for (const int rod : rods) is_any = add_distributed_load(given, rod, acting, files, context) || is_any;
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
        refuse(given.file, "on", "at", "force, moment");
    }
    if (given.file && (given.force_per_length || given.moment_per_length))
        context.add_fault(given, given.file, "has the loads along the rod; expected no values next to it");
}

// Adds what a table says, at points or along rods.
void add_load(const LoadTable& given, const Acting& acting, const LoadFiles& files, BuildContext& context) {
    const bool has_points = given.force || given.moment;
    const bool is_along = given.force_per_length || given.moment_per_length || given.file;
    if (!has_points && !is_along)
        return context.add_fault(
            given,
            given.where,
            "nothing acts there; expected force or moment, or force_per_length or moment_per_length");
    if (given.at || (has_points && !given.on)) {
        for (const PlacedPoint& point : find_points(given, given.at, given.where, context))
            add_nodal_load(given, point, acting, context);
    }
    if (given.on || (is_along && !given.at)) add_distributed_loads(given, acting, files, context);
}

std::array<ColumnPattern, 6> read_patterns(const LoadColumnsTable& given, FaultList& faults) {
    std::array<ColumnPattern, 6> patterns;
    const std::array fields{&given.fx, &given.fy, &given.fz, &given.mx, &given.my, &given.mz};
    bool is_any = false;
    for (std::size_t i = 0; i < 6; ++i) {
        if (!*fields[i]) continue;
        is_any = true;
        if (!parse_pattern(**fields[i], patterns[i]))
            faults.add(given.place_of(fields[i]),
                       given.path_of(fields[i]),
                       fmt::format("expected a name with one * for the number of the station, found \"{}\"",
                                   **fields[i]));
    }
    if (!is_any)
        faults.add(given.place, given.path, "names no column; expected one of fx, fy, fz, mx, my, mz");
    return patterns;
}

// Adds a fault unless the stations' arc lengths rise.
void check_load_stations(const LoadTable& given, FaultList& faults) {
    if (!given.stations) {
        faults.add(given.columns->place,
                   given.path,
                   "has columns without `stations`, the arc lengths of the stations that they number");
    } else if (std::ranges::adjacent_find(*given.stations, std::greater_equal<>()) != given.stations->end()) {
        faults.add(given.place_of(&given.stations),
                   given.path_of(&given.stations),
                   "expected arc lengths each above the one before");
    }
}

// The loads of a table; nothing with a fault.
std::shared_ptr<const StationLoads> take_loads(const LoadTable& given,
                                               const ColumnTable& table,
                                               FaultList& faults) {
    if (!given.columns) return std::make_shared<const StationLoads>(take_rows(table, *given.file));
    const std::size_t before = faults.count();
    const std::array<ColumnPattern, 6> patterns = read_patterns(*given.columns, faults);
    check_load_stations(given, faults);
    if (faults.count() > before) return nullptr;
    return std::make_shared<const StationLoads>(take_columns(table, patterns, *given.stations, *given.file));
}

bool is_fixed_in_space(const LoadTable& given) {
    return given.at && !given.where && given.force && given.frame == Frame::spatial &&
           std::ranges::none_of(*given.force, [](const CheckedMotionFunction& one) {
               return static_cast<bool>(one.expression.by_motion);
           });
}

}  // namespace

LoadFiles read_load_files(const CheckedTable& deck,
                          const TableFiles& files,
                          FaultList& faults,
                          std::vector<MeshRecord>& records) {
    LoadFiles found;
    std::map<std::string, ColumnTable> tables;  // files that are read
    for (const LoadTable& given : tables_of<LoadTable>(deck, load_table())) {
        if (!given.file) continue;
        try {
            if (!tables.contains(*given.file)) {
                const std::string bytes = files.read(*given.file);
                keep_file(*given.file, bytes, records);
                tables.emplace(*given.file, read_column_table(bytes, *given.file));
            }
            if (auto loads = take_loads(given, tables.at(*given.file), faults))
                found.emplace(given.path, std::move(loads));
        } catch (const FileError& error) {
            faults.add(given.place_of(&given.file), given.path_of(&given.file), error.what());
        }
    }
    return found;
}

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

void build_loads(const LoadFiles& files, BuildContext& context) {
    if (const CheckedTimeVector* gravity = find_gravity(context.deck)) {
        Acting acting = find_gravity_acting(context);
        acting.scale = find_gravity_factor(context);
        std::array<TimeFunction, 3> components;
        for (std::size_t i = 0; i < 3; ++i) components[i] = acting.apply((*gravity)[i].function);
        context.model.gravity = TimeVector(std::move(components));
    }
    for (const LoadTable& given : tables_of<LoadTable>(context.deck, load_table())) {
        if (context.stage == 0) {
            check_companions(given, context);
            if (given.axes != HistoryAxes::section && given.frame != Frame::body)
                context.add_fault(given, given.axes, "goes with frame = \"body\"");
        }
        const Acting acting = find_acting(given, context);
        if (acting.is_absent) continue;
        add_load(given, acting, files, context);
    }
}

}  // namespace gxrod
