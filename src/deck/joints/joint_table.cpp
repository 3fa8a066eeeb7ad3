#include "deck/joints/joint_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>

#include "deck/supports/components.hpp"
#include "model/ties/joint_card.hpp"

namespace gxrod {
namespace {

// The coordinate that the keys of a table are for.
enum class KeysOf { either, turn, slide };

std::string pick(KeysOf which, const std::string& either, const std::string& turn, const std::string& slide) {
    return which == KeysOf::either ? either : which == KeysOf::turn ? turn : slide;
}

std::string choose(KeysOf which, const std::string& turn, const std::string& slide) {
    return pick(which, turn + " or " + slide, turn, slide);
}

// Declares a table of either coordinate, with tables of each in it. `declare` adds the keys that the three
// have, and returns those of which a table needs one.
template <class One, class Declare>
const TableSpec& make_table(const std::string& key, Declare declare) {
    using Either = CoordinateTable<One>;
    const std::string path = "joint.NAME." + key;
    const auto make_one = [&](const std::string& name, KeysOf which) {
        Table<One> table(path + "." + name, "");
        TableSpec spec = table.at_least_one_of(declare(table, which));
        return spec;
    };
    static const TableSpec turn = make_one("turn", KeysOf::turn);
    static const TableSpec slide = make_one("slide", KeysOf::slide);
    static const TableSpec either = [&]() -> TableSpec {
        Table<Either> table(path, "");
        std::vector<std::string> needed = declare(table, KeysOf::either);
        needed.insert(needed.end(), {"turn", "slide"});
        return table.key("turn", &Either::turn, turn, "Of the turn of a joint that has a slide, too.")
            .key("slide", &Either::slide, slide, "Of the slide of a joint that has a turn, too.")
            .at_least_one_of(needed);
    }();
    return either;
}

const TableSpec& joint_spring_table() {
    return make_table<JointSpringTable>("spring", []<class T>(Table<T>& table, KeysOf which) {
        // clang-format off
        table
            .key("stiffness", &T::stiffness, "Moment or force back to `rest`, per angle or length from there.")
                .unit(choose(which, "moment/angle", "force/length")).at_least(0).also("k spring_constant")
            .key("damping", &T::damping, "Moment or force per rate of the coordinate.")
                .unit(choose(which, "moment·time/angle", "force·time/length")).at_least(0).also("c d viscosity")
            .key("rest", &T::rest, "Where the spring exerts nothing.")
                .unit(choose(which, "angle", "length")).otherwise("0: the place at t = 0").only_with("stiffness")
                .also("rest_angle rest_length free_angle angle0 length neutral");
        // clang-format on
        return std::vector<std::string>{"stiffness", "damping"};
    });
}

const TableSpec& friction_table() {
    return make_table<JointFrictionTable>("friction", []<class T>(Table<T>& table, KeysOf which) {
        std::vector<std::string> sizes;
        // clang-format off
        if (which != KeysOf::slide) {
            sizes.emplace_back("moment");
            table.key("moment", &T::moment, "Moment that resists a turn.")
                .unit("moment").at_least(0).also("torque mc");
        }
        if (which != KeysOf::turn) {
            sizes.emplace_back("force");
            table.key("force", &T::force, "Force that resists a slide.")
                .unit("force").at_least(0);
        }
        sizes.emplace_back("coefficient");
        table.key("coefficient", &T::coefficient,
                  pick(which,
                       "Friction by the force that the joint holds: of a turn coefficient × radius × force, of a slide "
                       "coefficient × force.",
                       "The moment is coefficient × radius × the force that the joint holds.",
                       "The force is coefficient × the force that the joint holds."))
            .unit("1").at_least(0);
        if (which != KeysOf::slide)
            table.key("radius", &T::radius, "Of the pin of a turn. Required with coefficient.")
                .unit("length").above(0).only_with("coefficient");
        table.key("stick", &T::stick, "How far the joint gives way, like a spring, before it slips.")
            .unit(choose(which, "angle", "length")).above(0)
            .otherwise(pick(which, "1e-4 of a turn, 1e-5 of the model's size of a slide", "1e-4",
                            "1e-5 of the model's size"))
            .also("stick_angle stick_length stiffness");
        // clang-format on
        if (which == KeysOf::either) table.at_most_one_of(sizes);
        return sizes;
    });
}

const TableSpec& limits_table() {
    return make_table<JointLimitsTable>("limits", []<class T>(Table<T>& table, KeysOf which) {
        // clang-format off
        table
            .key("lower", &T::lower, "Below it a spring, or a stop, pushes the coordinate up.")
                .unit(choose(which, "angle", "length")).otherwise("none").also("min minimum from")
            .key("upper", &T::upper, "Above it a spring, or a stop, pushes the coordinate down.")
                .unit(choose(which, "angle", "length")).otherwise("none").also("max maximum to")
            .key("stiffness", &T::stiffness, "Of that spring.")
                .unit(choose(which, "moment/angle", "force/length")).above(0)
                .otherwise("a stop, which holds at the bound and does not rebound").also("k")
            .key("damping", &T::damping, "Of a damper that acts with it.")
                .unit(choose(which, "moment·time/angle", "force·time/length")).at_least(0).also("c d");
        // clang-format on
        return std::vector<std::string>{"lower", "upper"};
    });
}

const TableSpec& clearance_table() {
    using T = JointClearanceTable;
    // clang-format off
    static const TableSpec table = Table<T>("joint.NAME.clearance", "")
        .key("gap", &T::gap, "How far the points are apart when they touch: the radius of the hole less that of the pin.")
            .unit("length").above(0).required().remark("the radius of the hole less that of the pin")
            .also("c size play radial_clearance clearance")
        .key("stiffness", &T::stiffness, "Of the contact: the force is stiffness × depth^exponent.")
            .unit("force/length^exponent").above(0).required().remark("of the contact").also("k hertz_stiffness")
        .key("exponent", &T::exponent, "Of the depth: 1.5 of a ball by Hertz.")
            .unit("1").between(1, 3).also("n power")
        .key("damping", &T::damping, "Force per rate of the depth; contact never pulls.")
            .unit("force·time/length").at_least(0).also("c_d d viscosity")
        .key("restitution", &T::restitution, "How much of its speed an impact gives back, close to 1: the force is multiplied by "
             "1 + 3 (1 − restitution²)/(4 impact_speed) × the rate of the depth.")
            .unit("1").between(0, 1).otherwise("no such loss").also("e coefficient_of_restitution")
        .key("impact_speed", &T::impact_speed, "The speed of impact for which restitution is given. Required with it.")
            .unit("length/time").above(0).only_with("restitution").also("initial_speed v0")
        .key("friction", &T::friction, "Coulomb's coefficient on the surface of the pin or ball.")
            .unit("1").at_least(0).also("mu friction_coefficient coefficient")
        .key("radius", &T::radius, "Of the pin or ball. Required with friction.")
            .unit("length").above(0).only_with("friction").also("pin_radius journal_radius")
        .key("slip_speed", &T::slip_speed, "The speed of slip at which friction has 0.7 of its limit. Required with friction.")
            .unit("length/time").above(0).only_with("friction").also("transition_speed v_s")
        .at_most_one_of({"damping", "restitution"});
    // clang-format on
    return table;
}

const TableSpec& break_table() {
    using T = JointBreakTable;
    // clang-format off
    static const TableSpec table = Table<T>("joint.NAME.breaks", "")
        .key("force", &T::force, "The largest force that the joint holds.").unit("force").above(0)
        .key("moment", &T::moment, "The largest moment that the joint holds, with that about axes that are not free.")
            .unit("moment").above(0).also("torque")
        .key("time", &T::time, "When it breaks, whatever it holds: t of the stage. A step ends there.")
            .unit("time").above(0).otherwise("when it holds too much").also("t at at_time fail_time")
        .key("stage", &T::stage, "The stage with that t, dynamic or quasi-static.")
            .otherwise("the only one in time in which the joint acts").names_of({"stage"}).only_with("time")
        .at_least_one_of({"force", "moment", "time"});
    // clang-format on
    return table;
}

const TableSpec& cam_curve_table() {
    using T = CamCurveTable;
    // clang-format off
    static const TableSpec table = Table<T>("joint.NAME.curve", "")
        .key("points", &T::points, "Points of the curve in their order, along x_axis and the axis at right angles to it and "
             "to `axis`, six at least. A quintic spline by arc length goes through them.")
            .unit("length").also("rows profile xy")
        .key("file", &T::file, "A CSV file of two columns with these points. Relative to the deck's folder.")
            .also("csv")
        .key("radius", &T::radius, "The distance of the curve from A's point by the angle from x_axis, right-handed about "
             "`axis`.")
            .unit("length").also("r polar")
        .key("closed", &T::closed, "Whether the curve comes back to its first point. false: the point has to stay between "
             "its ends.")
            .otherwise("true").also("is_closed periodic")
        .exactly_one_of({"points", "file", "radius"});
    // clang-format on
    return table;
}

bool is_sleeve(const JointCard& card) { return card.kind == JointKind::sleeve; }
bool is_generic(const JointCard& card) { return card.kind == JointKind::generic; }
bool is_cam(const JointCard& card) { return card.kind == JointKind::cam; }
bool is_distance(const JointCard& card) { return card.kind == JointKind::distance; }
bool is_between_nodes(const JointCard& card) { return !is_sleeve(card); }
bool holds_anything(const JointCard& card) { return is_between_nodes(card) && card.kind != JointKind::free; }
bool is_at_two_places(const JointCard& card) { return !card.is_at_one_place; }
bool has_free_coordinate(const JointCard& card) { return card.has_turn || card.has_slide; }
bool has_axis(const JointCard& card) {
    return (has_free_coordinate(card) && is_between_nodes(card)) || is_generic(card) || is_cam(card);
}
bool can_be_loose(const JointCard& card) {
    return card.kind == JointKind::ball || card.kind == JointKind::hinge || card.kind == JointKind::cylinder;
}
bool has_lead(const JointCard& card) { return card.kind == JointKind::screw; }

// The types of joints whose cards fit; `fits` is a function or a member of the card.
template <class Fits>
std::vector<Condition> types_that(const Fits& fits) {
    Condition condition{"type", {}};
    for (const JointCard& card : joint_cards) {
        if (std::invoke(fits, card)) condition.words.emplace_back(card.word);
    }
    return {condition};
}

// The keys of a generic joint besides its axis.
void add_generic_keys(Table<JointTable>& table) {
    using T = JointTable;
    // clang-format off
    table
        .key("y_axis", &T::y_axis, "Of a generic joint: its y axis, at right angles to `axis`, which is x. A carries both.")
            .unit("1").otherwise("towards the global axis that is most across `axis`").only_for(types_that(is_generic))
        .key("holds", &T::holds, "Of a generic joint: the displacements of B along the joint's axes (x, y, z, or position for "
             "all) and its turns about them (rx, ry, rz, or rotation) that are held. Where one turn is held, the other two "
             "are those of a universal joint.")
            .words(component_words()).required().remark("what it holds, as in [\"y\", \"z\"]").only_for(types_that(is_generic))
            .also("fix fixed locks constrains directions");
    // clang-format on
}

// The keys of single types.
void add_shape_keys(Table<JointTable>& table) {
    using T = JointTable;
    // clang-format off
    table
        .key("lead", &T::lead, "Of a screw: the slide along the axis in one turn; negative if left-handed.")
            .unit("length").required().remark("the slide in one turn").only_for(types_that(has_lead)).also("pitch")
        .key("length", &T::length, "Of a distance: that of the points, for a check of where they are; if it can be "
             "slack, the largest one.")
            .unit("length").above(0).otherwise("as it is at t = 0").only_for(types_that(is_distance))
            .also("distance l l0")
        .key("slack", &T::slack, "Of a distance: holds only where the points would be further apart than `length`, as a rope "
             "does. When it becomes taut it does not rebound.")
            .otherwise("false").only_for(types_that(is_distance)).also("rope tension_only pulls_only cable")
        .key("turn", &T::turn, "Of a sleeve: whether the point turns as it likes. false: it does not turn against the rod's "
             "section at the place where it is.")
            .otherwise("true").only_for(types_that(is_sleeve)).also("turns rotates rotation_free");
    // clang-format on
}

// The keys of a cam besides its axis.
void add_cam_keys(Table<JointTable>& table) {
    using T = JointTable;
    // clang-format off
    table
        .key("curve", &T::curve, cam_curve_table(), "Of a cam: the curve that A carries, in a plane across `axis`. Its "
             "origin is A's point.")
            .required().remark("its points, file or radius").only_for(types_that(is_cam)).also("profile shape contour cam_curve")
        .key("x_axis", &T::x_axis, "Of a cam: the direction of the first coordinate of its curve, at right angles to `axis`, at "
             "t = 0.")
            .unit("1").otherwise("towards the global axis that is most across `axis`").only_for(types_that(is_cam))
        .key("roller", &T::roller, "Of a cam: the radius of the roller around B's point that stays on the curve, on the side "
             "where it is at t = 0.")
            .unit("length").at_least(0).otherwise("0: the point is a knife edge").only_for(types_that(is_cam))
            .also("roller_radius rho follower_radius")
        .key("lifts", &T::lifts, "Of a cam: whether the roller can leave the curve. When it comes back it does not rebound. "
             "false: it is held from both sides, as in a groove.")
            .otherwise("false").only_for(types_that(is_cam)).also("one_sided unilateral lift_off can_lift");
    // clang-format on
}

// The keys of what acts on a coordinate.
void add_coordinate_keys(Table<JointTable>& table) {
    using T = JointTable;
    // clang-format off
    table
        .key("move", &T::move, "A motor: the coordinate since t = 0. It is 0 at t = 0 in a dynamic analysis. A turn "
             "is the right-hand one of B against A, a slide that of B along the axis.")
            .unit("angle or length").otherwise("free").only_for(types_that(has_free_coordinate))
            .also("motor motion prescribed angle rotation displacement slide")
        .key("drive", &T::drive, "Moment, or force, that A exerts on B along the axis.")
            .unit("moment or force").otherwise("0").only_for(types_that(has_free_coordinate))
            .also("actuator torque force moment motor_torque")
        .key("spring", &T::spring, joint_spring_table(),
             "A spring and a damper on the coordinate, for any number of turns.")
            .only_for(types_that(has_free_coordinate)).has_as("spring.stiffness", "stiffness k")
            .has_as("spring.damping", "damping damper c")
        .key("friction", &T::friction, friction_table(), "Dry friction of the coordinate.")
            .only_for(types_that(has_free_coordinate))
        .key("limits", &T::limits, limits_table(), "Springs or stops at the ends of a coordinate's range.")
            .only_for(types_that(has_free_coordinate)).also("limit stops stop range bounds");
    // clang-format on
}

// The keys that say when a joint holds.
void add_holding_keys(Table<JointTable>& table) {
    using T = JointTable;
    // clang-format off
    table
        .key("clearance", &T::clearance, clearance_table(), "Of a pin in its hole, or a ball in its socket: the points are free "
             "within a gap, across the axis of a hinge or cylinder, and touch beyond it. B carries the pin.")
            .otherwise("none").only_for(types_that(can_be_loose)).also("play gap backlash")
        .key("breaks", &T::breaks, break_table(), "The joint breaks at the end of a step in which it holds more, or at a "
             "time, and holds nothing from then on: neither its equations nor what acts on its coordinates.")
            .only_for(types_that(holds_anything)).also("break strength breaks_at break_at fails")
        .key("stages", &T::stages, "The stages in which the joint holds. It has to be closed where it begins to hold.")
            .otherwise("all").names_of({"stage"}).only_for(types_that(is_between_nodes));
    // clang-format on
}

std::string describe_types() {
    std::string text = "What it leaves free.";
    for (const JointCard& card : joint_cards) text += fmt::format(" {}: {}.", card.word, card.leaves_free);
    return text + " A free joint is for what acts on its turn and its slide.";
}

}  // namespace

const TableSpec& joint_table() {
    using T = JointTable;
    // clang-format off
    static const TableSpec table = Table<T>("[joint.NAME]",
            "What two points, A and B, of rods, bodies or the ground can still do against each other. Angles and "
            "lengths of its coordinates are 0 at t = 0, forces and moments are those that A exerts on B.")
        .key("type", &T::type, describe_types())
            .required().also("kind joint joint_type")
        .key("between", &T::between, "A and B: points of rods, bodies, or \"ground\" for what does not move. A point "
             "can be in several joints. Of a sleeve, A is a rod.")
            .required().also("bodies points nodes parts from to connects parent child")
        .key("at", &T::at, "Where the joint is at t = 0, global. Rigid arms join it to the nodes of A and B.")
            .unit("length").otherwise("where A and B are, at one place; else the point of the only rod")
            .only_for(types_that(&JointCard::is_at_one_place)).also("pos position point place location anchor origin")
        .key("at_a", &T::at_a, "Where A's point is at t = 0, global.")
            .unit("length").otherwise("where its node is; of the ground required").only_for(types_that(is_at_two_places))
            .also("point_a position_a")
        .key("at_b", &T::at_b, "Where B's point is at t = 0, global.")
            .unit("length").otherwise("where its node is; of the ground required").only_for(types_that(is_at_two_places))
            .also("point_b position_b")
        .key("axis", &T::axis,
             "Its axis, of a plane the normal: global at t = 0, of any length; A and B carry it.")
            .unit("1").required().remark("the direction of its axis at t = 0, global").only_for(types_that(has_axis))
            .also("direction normal axis_a rotation_axis")
        .with(add_generic_keys)
        .key("axis_b", &T::axis_b, "Of a universal joint: the axis fixed in B, at right angles to `axis`.")
            .unit("1").required().remark("the axis that B carries").only_for(types_that(&JointCard::has_axis_b))
        .with(add_shape_keys)
        .with(add_cam_keys)
        .with(add_coordinate_keys)
        .with(add_holding_keys)
        .with(add_copies<T>)
        .shown_by(
            "[joint.pivot]\n"
            "type    = \"hinge\"\n"
            "between = [\"tail.end\", \"gyroscope\"]\n"
            "axis    = [0, 1, 0]\n"
            "spring  = { stiffness = 2.0, damping = 0.01 }\n");
    // clang-format on
    return table;
}

const JointTable* find_joint(const CheckedTable& deck, std::string_view name) {
    const auto joints = tables_of<JointTable>(deck, joint_table());
    const auto found =
        std::ranges::find_if(joints, [&](const JointTable& joint) { return joint.name == name; });
    return found == joints.end() ? nullptr : &found->get();
}

}  // namespace gxrod
