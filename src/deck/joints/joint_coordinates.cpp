#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "deck/checks/check_moves.hpp"
#include "deck/joints/joint_table.hpp"
#include "deck/loads/acting.hpp"
#include "deck/places/angle_note.hpp"
#include "model/ties/joint_card.hpp"

namespace gxrod {
namespace {

// Of a turn in rad, and of a slide relative to the model's size.
constexpr double turn_stick = 1e-4;
constexpr double slide_stick = 1e-5;

constexpr std::array<std::string_view, 2> coordinate_names{"turn", "slide"};

bool has_coordinate(JointKind kind, std::string_view name) {
    return name == "turn" ? card_of(kind).has_turn : card_of(kind).has_slide;
}

// The coordinate of a value of `move` or `drive`.
std::string_view name_coordinate(const CheckedNamedFunction& value, JointKind kind) {
    return value.name.empty() ? plain_coordinate(kind) : std::string_view(value.name);
}

// What a deck gives one coordinate; nullptr where it gives nothing.
struct GivenActions {
    const CheckedTimeFunction* move;
    const CheckedTimeFunction* drive;
    const JointSpringTable* spring;
    const JointFrictionTable* friction;
    const JointLimitsTable* limits;
};

GivenActions find_actions(const JointTable& given, std::string_view coordinate) {
    const auto find_function =
        [&](const std::optional<CoordinateFunctions>& functions) -> const CheckedTimeFunction* {
        if (!functions) return nullptr;
        const auto found = std::ranges::find_if(functions->named, [&](const CheckedNamedFunction& one) {
            return name_coordinate(one, given.type) == coordinate;
        });
        return found == functions->named.end() ? nullptr : &found->value;
    };
    const auto find_table = [&]<class One>(const std::optional<CoordinateTable<One>>& table) -> const One* {
        if (!table) return nullptr;
        const std::optional<One>& own = coordinate == "turn" ? table->turn : table->slide;
        if (own) return &*own;
        const bool is_named = table->turn || table->slide;
        return !is_named && plain_coordinate(given.type) == coordinate ? &*table : nullptr;
    };
    return {find_function(given.move),
            find_function(given.drive),
            find_table(given.spring),
            find_table(given.friction),
            find_table(given.limits)};
}

// Says that a key has to name its coordinate, or names one that the joint has not.
class CoordinateCheck {
  public:
    CoordinateCheck(const JointTable& given, const BuildContext& context)
        : given_(given),
          type_(given.type == JointKind::free ? "free joint" : card_of(given.type).word),
          context_(context) {}

    void check() const {
        check_functions_of(given_.move);
        check_functions_of(given_.drive);
        check_table(given_.spring);
        check_table(given_.friction);
        check_table(given_.limits);
        for (const std::string_view coordinate : coordinate_names) {
            const GivenActions actions = find_actions(given_, coordinate);
            if (actions.move != nullptr) check_motor(actions, coordinate);
            if (actions.friction != nullptr) check_friction(*actions.friction, coordinate);
            if (actions.limits != nullptr) check_limits(*actions.limits);
            if (actions.limits != nullptr && !actions.limits->stiffness)
                check_stop(*actions.limits, actions, coordinate);
        }
    }

  private:
    void add(const Place& place, const std::string& path, std::string message) const {
        context_.faults.add(place, path, std::move(message));
    }

    void add_lack(const Place& place, const std::string& path, std::string_view coordinate) const {
        add(place, path, fmt::format("a {} has no {}", type_, coordinate));
    }

    void check_functions_of(const std::optional<CoordinateFunctions>& functions) const {
        if (!functions) return;
        for (const auto& [word, value] : functions->named) {
            const std::string_view name = word.empty() ? plain_coordinate(given_.type) : word;
            if (name.empty()) {
                add(value.place,
                    value.path,
                    fmt::format(
                        "a {} has a turn and a slide; expected {} = {{ turn = … }}, {{ slide = … }} or "
                        "both",
                        type_,
                        given_.key_of(&functions).name));
            } else if (!has_coordinate(given_.type, name)) {
                add_lack(value.place, value.path, name);
            }
        }
    }

    template <class One>
    void check_table(const std::optional<CoordinateTable<One>>& table) const {
        if (!table) return;
        for (const auto& [key, place] : table->given) {
            const std::string path = table->path + "." + key;
            if (key == "turn" || key == "slide") {
                if (!has_coordinate(given_.type, key)) add_lack(place, path, key);
            } else if (table->turn || table->slide) {
                add(place, path, "belongs into turn or slide, where this table has these");
            } else if (plain_coordinate(given_.type).empty()) {
                return add(table->place,
                           table->path,
                           fmt::format("a {} has a turn and a slide; expected {} = {{ turn = {{ … }} }}, {{ "
                                       "slide = {{ … }} }} or both",
                                       type_,
                                       given_.key_of(&table).name));
            }
        }
    }

    void check_motor(const GivenActions& actions, std::string_view coordinate) const {
        const CheckedTimeFunction& move = *actions.move;
        if (actions.drive != nullptr) {
            add(actions.drive->place,
                actions.drive->path,
                fmt::format("`move` says what the {} is, whatever drives it; expected one of the two",
                            coordinate));
        }
        const bool is_screw = given_.type == JointKind::screw && coordinate == "slide";
        if (is_screw && find_actions(given_, "turn").move != nullptr)
            add(move.place, move.path, "the turn of a screw says what its slide is; expected one of them");
    }

    void check_friction(const JointFrictionTable& friction, std::string_view coordinate) const {
        const bool is_turn = coordinate == "turn";
        check_coefficient(friction, is_turn);
        const std::optional<double>& wrong = is_turn ? friction.force : friction.moment;
        if (!wrong) return;
        context_.add_fault(
            friction,
            wrong,
            fmt::format("the friction of a {} is a {}", coordinate, is_turn ? "moment" : "force"));
    }

    // The friction of a turn needs a radius at which its force acts, and that of a slide none.
    void check_coefficient(const JointFrictionTable& friction, bool is_turn) const {
        if (!friction.coefficient) return;
        if (given_.type == JointKind::free) {
            context_.add_fault(
                friction, friction.coefficient, "a free joint holds no force; expected moment or force");
        } else if (is_turn && !friction.radius) {
            context_.add_fault(
                friction,
                friction.radius,
                "missing; expected the radius of the pin, a number greater than 0 or an expression");
        } else if (!is_turn && friction.radius) {
            context_.add_fault(friction, friction.radius, "only the friction of a turn has a radius");
        }
    }

    void check_limits(const JointLimitsTable& limits) const {
        if (!limits.lower || !limits.upper || *limits.lower <= *limits.upper) return;
        context_.add_fault(
            limits, limits.lower, fmt::format("{:.6g} is above upper, {:.6g}", *limits.lower, *limits.upper));
    }

    // A stop holds at its bounds, one of which is there, and does not push what is beyond them at t = 0.
    void check_stop(const JointLimitsTable& limits,
                    const GivenActions& actions,
                    std::string_view coordinate) const {
        const auto expect_stiffness = [&](const std::string& what) {
            context_.add_fault(limits, limits.stiffness, "missing; " + what + "; expected a stiffness");
        };
        if (limits.gives(limits.damping)) return expect_stiffness("a stop has no damping");
        if (given_.is_sleeve()) return expect_stiffness("the limits of a sleeve are springs");
        if (actions.move != nullptr)
            return expect_stiffness(
                fmt::format("`move` says what the {} is, and a stop without stiffness holds it", coordinate));
        if (given_.type == JointKind::screw && given_.limits->turn && given_.limits->slide)
            return expect_stiffness("the turn of a screw says what its slide is, and one stop is enough");
        if (limits.lower && limits.upper && *limits.lower == *limits.upper)
            return expect_stiffness(fmt::format("the {} has no range between the stops", coordinate));
        if (limits.lower && *limits.lower > 0.0)
            context_.add_fault(limits, limits.lower, describe_outside(*limits.lower, "above", coordinate));
        if (limits.upper && *limits.upper < 0.0)
            context_.add_fault(limits, limits.upper, describe_outside(*limits.upper, "below", coordinate));
    }

    static std::string describe_outside(double bound, std::string_view where, std::string_view coordinate) {
        return fmt::format(
            "{:.6g} is {} 0, the {} at t = 0, where a stop would jump; expected 0 between the stops, or a "
            "stiffness",
            bound,
            where,
            coordinate);
    }

    const JointTable& given_;
    const std::string_view type_;
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

Friction build_friction(const JointFrictionTable& given, double default_stick) {
    Friction built;
    built.force = given.moment ? *given.moment : given.force.value_or(0.0);
    built.stick = given.stick.value_or(default_stick);
    built.lever = given.coefficient.value_or(0.0);
    if (given.radius) built.lever *= *given.radius;
    return built;
}

JointCoordinate build_coordinate(const JointTable& given,
                                 std::string_view coordinate,
                                 double default_stick,
                                 const BuildContext& context) {
    const auto [move, drive, spring, friction, limits] = find_actions(given, coordinate);
    const Acting acting = find_acting(context);
    JointCoordinate built;
    if (move != nullptr) built.motion = acting.apply(move->function);
    if (drive != nullptr) built.drive = acting.apply(drive->function);
    if (spring != nullptr) {
        built.stiffness = spring->stiffness;
        built.damping = spring->damping;
        if (spring->rest) built.rest = acting.apply(spring->rest->function);
    }
    if (friction != nullptr) built.friction = build_friction(*friction, default_stick);
    if (limits != nullptr)
        built.limits = {limits->lower, limits->upper, limits->stiffness.value_or(0.0), limits->damping};
    return built;
}

}  // namespace

std::string_view plain_coordinate(JointKind kind) {
    const JointCard& card = card_of(kind);
    if (!card.has_slide || kind == JointKind::screw) return "turn";
    return card.has_turn ? "" : "slide";
}

std::vector<const CheckedTimeFunction*> functions_of(const JointTable& joint) {
    std::vector<const CheckedTimeFunction*> functions;
    for (const CoordinateFunctions& given : values_of<CoordinateFunctions>(joint)) {
        for (const CheckedNamedFunction& one : given.named) functions.push_back(&one.value);
    }
    const auto add_rest = [&](const auto& spring) {
        if (spring && spring->rest) functions.push_back(&*spring->rest);
    };
    add_rest(joint.spring);
    if (!joint.spring) return functions;
    add_rest(joint.spring->turn);
    add_rest(joint.spring->slide);
    return functions;
}

void check_coordinates(const JointTable& given, const BuildContext& context) {
    CoordinateCheck(given, context).check();
}

void note_coordinates(const JointTable& given, const Joint& joint, double size, const BuildContext& context) {
    const GivenActions turn = find_actions(given, "turn");
    if (turn.friction != nullptr && turn.friction->radius) {
        const double radius = *turn.friction->radius;
        const double length = find_joined_length(joint, size, context.model);
        if (radius > length) {
            context.notes.push_back(
                fmt::format("{}: {:.6g} is longer than what the joint joins, {:.6g}; the "
                            "radius is that of the pin on which the friction acts",
                            turn.friction->path_of(&turn.friction->radius),
                            radius,
                            length));
        }
    }
    if (turn.limits == nullptr) return;
    for (const std::optional<double>* bound : {&turn.limits->lower, &turn.limits->upper}) {
        const std::string note = *bound ? describe_many_turns(**bound) : "";
        if (!note.empty()) context.notes.push_back(turn.limits->path_of(bound) + ": " + note);
    }
}

void check_motors(const JointTable& given, double size, const BuildContext& context) {
    if (!given.move) return;
    for (const CheckedNamedFunction& move : given.move->named)
        check_move(move.value, name_coordinate(move, given.type) == "turn" ? 1.0 : size, context);
}

JointCoordinate build_slide(const JointTable& given, double size, const BuildContext& context) {
    JointCoordinate slide = build_coordinate(given, "slide", slide_stick * size, context);
    if (slide.friction.acts() && slide.friction.stick == 0.0) {
        context.add_fault(given,
                          given.friction,
                          "all is at one place, so the model has no size of which `stick` could be a part; "
                          "expected a stick");
    }
    return slide;
}

void set_coordinates(const JointTable& given, double size, Joint& joint, const BuildContext& context) {
    joint.turn = build_coordinate(given, "turn", turn_stick, context);
    joint.slide = build_slide(given, size, context);
    if (joint.kind != JointKind::screw || !joint.slide.motion) return;
    joint.turn.motion = scale(*joint.slide.motion, 2.0 * std::numbers::pi / joint.lead);
    joint.slide.motion.reset();
}

}  // namespace gxrod
