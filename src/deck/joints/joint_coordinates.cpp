#include "deck/joints/joint_coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "deck/loads/acting.hpp"
#include "deck/places/angle_note.hpp"

namespace gxrod {
namespace {

using NamedFunctions = std::vector<CheckedNamedFunction>;

// Of a turn in rad, and of a slide relative to the model's size.
constexpr double turn_stick = 1e-4;
constexpr double slide_stick = 1e-5;

constexpr std::array<const char*, 2> coordinate_names{"turn", "slide"};
constexpr std::array<const char*, 3> table_keys{"spring", "friction", "limits"};
constexpr std::array<const char*, 2> function_keys{"move", "drive"};

bool has_coordinate(const Joint& joint, std::string_view name) {
    return name == "turn" ? joint.has_turn() : joint.has_slide();
}

bool is_name(std::string_view key) { return key == "turn" || key == "slide"; }

const CheckedTable* find_table(const CheckedTable& joint, const char* key) {
    return joint.gives(key) ? &joint.tables(key).front() : nullptr;
}

// The table of one coordinate; nullptr if there is none.
const CheckedTable* find_table(const CheckedTable& joint,
                               const char* key,
                               JointKind kind,
                               std::string_view coordinate) {
    const CheckedTable* table = find_table(joint, key);
    if (table == nullptr) return nullptr;
    if (table->gives(coordinate)) return &table->tables(coordinate).front();
    const bool is_named = table->gives("turn") || table->gives("slide");
    return !is_named && plain_coordinate(kind) == coordinate ? table : nullptr;
}

const CheckedTimeFunction* find_function(const CheckedTable& joint,
                                         const char* key,
                                         JointKind kind,
                                         std::string_view coordinate) {
    if (!joint.gives(key)) return nullptr;
    for (const CheckedNamedFunction& one : joint.get<NamedFunctions>(key)) {
        if (name_coordinate(one, kind) == coordinate) return &one.value;
    }
    return nullptr;
}

// Says that a key has to name its coordinate, or names one that the joint has not.
class CoordinateCheck {
  public:
    CoordinateCheck(const CheckedTable& table, const Joint& joint, const BuildContext& context)
        : table_(table),
          joint_(joint),
          type_(joint.kind == JointKind::free ? "free joint" : table.get<std::string>("type")),
          context_(context) {}

    void check() const {
        for (const char* key : function_keys) check_functions_of(key);
        for (const char* key : table_keys) {
            if (const CheckedTable* table = find_table(table_, key)) check_table(key, *table);
        }
        for (const char* coordinate : coordinate_names) {
            check_motor(coordinate);
            check_friction(coordinate);
            check_limits(coordinate);
        }
    }

  private:
    void add(const Place& place, const std::string& path, std::string message) const {
        context_.faults.add(place, path, std::move(message));
    }

    void add_lack(const Place& place, const std::string& path, std::string_view coordinate) const {
        add(place, path, fmt::format("a {} has no {}", type_, coordinate));
    }

    void check_functions_of(const char* key) const {
        if (!table_.gives(key)) return;
        const NamedFunctions& functions = table_.get<NamedFunctions>(key);
        for (const CheckedNamedFunction& one : functions) {
            const std::string_view name = name_coordinate(one, joint_.kind);
            if (name.empty()) {
                add(one.value.place,
                    one.value.path,
                    fmt::format(
                        "a {} has a turn and a slide; expected {} = {{ turn = … }}, {{ slide = … }} or "
                        "both",
                        type_,
                        key));
            } else if (!has_coordinate(joint_, name)) {
                add_lack(one.value.place, one.value.path, name);
            }
        }
    }

    void check_table(const char* key, const CheckedTable& table) const {
        const bool is_named = table.gives("turn") || table.gives("slide");
        for (const CheckedValue& value : table.values) {
            if (!value.given) continue;
            const std::string path = table.path_of(value.key);
            if (is_name(value.key)) {
                if (!has_coordinate(joint_, value.key)) add_lack(value.place, path, value.key);
            } else if (is_named) {
                add(value.place, path, "belongs into turn or slide, where this table has these");
            } else if (plain_coordinate(joint_.kind).empty()) {
                return add(table.place,
                           table.path,
                           fmt::format("a {} has a turn and a slide; expected {} = {{ turn = {{ … }} }}, {{ "
                                       "slide = {{ … }} }} or both",
                                       type_,
                                       key));
            }
        }
    }

    void check_motor(const char* coordinate) const {
        const CheckedTimeFunction* move = find_function(table_, "move", joint_.kind, coordinate);
        const CheckedTimeFunction* drive = find_function(table_, "drive", joint_.kind, coordinate);
        if (move == nullptr) return;
        if (drive != nullptr) {
            add(drive->place,
                drive->path,
                fmt::format("`move` says what the {} is, whatever drives it; expected one of the two",
                            coordinate));
        }
        const bool is_screw = joint_.kind == JointKind::screw && std::string_view(coordinate) == "slide";
        if (is_screw && find_function(table_, "move", joint_.kind, "turn") != nullptr)
            add(move->place, move->path, "the turn of a screw says what its slide is; expected one of them");
    }

    void check_friction(const char* coordinate) const {
        const CheckedTable* friction = find_table(table_, "friction", joint_.kind, coordinate);
        if (friction == nullptr) return;
        const bool is_turn = std::string_view(coordinate) == "turn";
        check_coefficient(*friction, is_turn);
        const char* wrong = is_turn ? "force" : "moment";
        if (!friction->gives(wrong)) return;
        add(friction->place_of(wrong),
            friction->path_of(wrong),
            fmt::format("the friction of a {} is a {}", coordinate, is_turn ? "moment" : "force"));
    }

    // The friction of a turn needs a radius at which its force acts, and that of a slide none.
    void check_coefficient(const CheckedTable& friction, bool is_turn) const {
        if (!friction.gives("coefficient")) return;
        if (joint_.kind == JointKind::sleeve) {
            add(friction.place_of("coefficient"),
                friction.path_of("coefficient"),
                "the friction of a sleeve does not depend on the force that it holds; expected force");
        } else if (joint_.kind == JointKind::free) {
            add(friction.place_of("coefficient"),
                friction.path_of("coefficient"),
                "a free joint holds no force; expected moment or force");
        } else if (is_turn && !friction.gives("radius")) {
            add(friction.place,
                friction.path_of("radius"),
                "missing; expected the radius of the pin, a number greater than 0 or an expression");
        } else if (!is_turn && friction.gives("radius")) {
            add(friction.place_of("radius"),
                friction.path_of("radius"),
                "only the friction of a turn has a radius");
        }
    }

    void check_limits(const char* coordinate) const {
        const CheckedTable* limits = find_table(table_, "limits", joint_.kind, coordinate);
        if (limits == nullptr) return;
        if (!limits->gives("stiffness")) {
            add(limits->place,
                limits->path_of("stiffness"),
                "missing; expected a number greater than 0 or an expression");
        }
        if (!limits->gives("lower") || !limits->gives("upper")) return;
        const double lower = limits->get<double>("lower");
        const double upper = limits->get<double>("upper");
        if (lower <= upper) return;
        add(limits->place_of("lower"),
            limits->path_of("lower"),
            fmt::format("{:.6g} is above upper, {:.6g}", lower, upper));
    }

    const CheckedTable& table_;
    const Joint& joint_;
    const std::string type_;
    const BuildContext& context_;
};

// The length of the shortest rod that the joint joins; of bodies alone, the size of the model.
double find_joined_length(const Joint& joint, double size, const Model& model) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const Rod& rod : model.rods) {
        const auto has = [&](const JointSide& side) {
            return !side.anchor.is_ground() &&
                   std::ranges::find(rod.nodes, side.anchor.node) != rod.nodes.end();
        };
        if (has(joint.a) || has(joint.b)) shortest = std::min(shortest, rod.length);
    }
    return std::isfinite(shortest) ? shortest : size;
}

TimeFunction scale(const TimeFunction& function, double factor) {
    if (function.is_constant()) return TimeFunction(factor * function(0.0));
    return TimeFunction([function, factor](double t) { return factor * function(t); }, function.switches());
}

class CoordinateBuilder {
  public:
    CoordinateBuilder(const CheckedTable& table,
                      JointKind kind,
                      const char* coordinate,
                      const BuildContext& context)
        : table_(table), kind_(kind), coordinate_(coordinate), acting_(find_acting(context)) {}

    JointCoordinate build(double default_stick) const {
        JointCoordinate built;
        if (const auto* move = find_function(table_, "move", kind_, coordinate_))
            built.motion = acting_.apply(move->function);
        if (const auto* drive = find_function(table_, "drive", kind_, coordinate_))
            built.drive = acting_.apply(drive->function);
        if (const CheckedTable* spring = find_table(table_, "spring", kind_, coordinate_))
            set_spring(*spring, built);
        if (const CheckedTable* friction = find_table(table_, "friction", kind_, coordinate_))
            built.friction = build_friction(*friction, default_stick);
        if (const CheckedTable* limits = find_table(table_, "limits", kind_, coordinate_))
            built.limits = build_limits(*limits);
        return built;
    }

  private:
    void set_spring(const CheckedTable& spring, JointCoordinate& built) const {
        built.stiffness = spring.get<double>("stiffness");
        built.damping = spring.get<double>("damping");
        if (spring.gives("rest"))
            built.rest = acting_.apply(spring.get<CheckedTimeFunction>("rest").function);
    }

    static Friction build_friction(const CheckedTable& friction, double default_stick) {
        const char* key = friction.gives("moment") ? "moment" : "force";
        Friction built;
        if (friction.gives(key)) built.force = friction.get<double>(key);
        built.stick = friction.gives("stick") ? friction.get<double>("stick") : default_stick;
        if (friction.gives("coefficient")) built.lever = friction.get<double>("coefficient");
        if (friction.gives("radius")) built.lever *= friction.get<double>("radius");
        return built;
    }

    static CoordinateLimits build_limits(const CheckedTable& limits) {
        CoordinateLimits built;
        built.damping = limits.get<double>("damping");
        if (limits.gives("stiffness")) built.stiffness = limits.get<double>("stiffness");
        if (limits.gives("lower")) built.lower = limits.get<double>("lower");
        if (limits.gives("upper")) built.upper = limits.get<double>("upper");
        return built;
    }

    const CheckedTable& table_;
    JointKind kind_;
    const char* coordinate_;
    Acting acting_;
};

}  // namespace

std::string_view plain_coordinate(JointKind kind) {
    if (kind == JointKind::cylinder || kind == JointKind::free) return "";
    return kind == JointKind::slider || kind == JointKind::sleeve ? "slide" : "turn";
}

std::string_view name_coordinate(const CheckedNamedFunction& value, JointKind kind) {
    return value.name.empty() ? plain_coordinate(kind) : std::string_view(value.name);
}

std::vector<CheckedNamedFunction> joint_moves_of(const CheckedTable& joint) {
    return joint.gives("move") ? joint.get<NamedFunctions>("move") : NamedFunctions{};
}

std::vector<const CheckedTimeFunction*> functions_of(const CheckedTable& joint) {
    std::vector<const CheckedTimeFunction*> functions;
    for (const char* key : function_keys) {
        if (!joint.gives(key)) continue;
        for (const CheckedNamedFunction& one : joint.get<NamedFunctions>(key))
            functions.push_back(&one.value);
    }
    const CheckedTable* spring = find_table(joint, "spring");
    if (spring == nullptr) return functions;
    std::vector<const CheckedTable*> springs{spring};
    for (const char* coordinate : coordinate_names) {
        if (spring->gives(coordinate)) springs.push_back(&spring->tables(coordinate).front());
    }
    for (const CheckedTable* one : springs) {
        if (one->gives("rest")) functions.push_back(&one->get<CheckedTimeFunction>("rest"));
    }
    return functions;
}

void check_coordinates(const CheckedTable& table, const Joint& joint, const BuildContext& context) {
    CoordinateCheck(table, joint, context).check();
}

void note_coordinates(const CheckedTable& table,
                      const Joint& joint,
                      double size,
                      const BuildContext& context) {
    const auto* friction = find_table(table, "friction", joint.kind, "turn");
    if (friction != nullptr && friction->gives("radius")) {
        const double radius = friction->get<double>("radius");
        const double length = find_joined_length(joint, size, context.model);
        if (radius > length) {
            context.notes.push_back(
                fmt::format("{}: {:.6g} is longer than what the joint joins, {:.6g}; the "
                            "radius is that of the pin on which the friction acts",
                            friction->path_of("radius"),
                            radius,
                            length));
        }
    }
    const auto* limits = find_table(table, "limits", joint.kind, "turn");
    if (limits == nullptr) return;
    for (const char* key : {"lower", "upper"}) {
        if (!limits->gives(key)) continue;
        const std::string note = describe_many_turns(limits->get<double>(key));
        if (!note.empty()) context.notes.push_back(limits->path_of(key) + ": " + note);
    }
}

void set_coordinates(const CheckedTable& table, double size, Joint& joint, const BuildContext& context) {
    joint.turn = CoordinateBuilder(table, joint.kind, "turn", context).build(turn_stick);
    joint.slide = CoordinateBuilder(table, joint.kind, "slide", context).build(slide_stick * size);
    if (joint.slide.friction.acts() && joint.slide.friction.stick == 0.0) {
        context.add_fault(table,
                          "friction",
                          "all is at one place, so the model has no size of which `stick` could be a part; "
                          "expected a stick");
    }
    if (joint.kind != JointKind::screw || !joint.slide.motion) return;
    joint.turn.motion = scale(*joint.slide.motion, 2.0 * std::numbers::pi / joint.lead);
    joint.slide.motion.reset();
}

}  // namespace gxrod
