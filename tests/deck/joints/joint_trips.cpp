#include <cmath>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"
#include "deck/schema/choices.hpp"
#include "model/spring_law.hpp"

namespace gxrod::test {
namespace {

Joint joint_of(const Problem& p) { return p.model.joints.at(0); }

// body_deck with a joint of this type from the ground to its body.
std::string with_joint(const std::string& type, const std::string& lines) {
    return body_deck + "[joint.j]\ntype = \"" + type + "\"\nbetween = [\"ground\", \"top\"]\n" + lines;
}

// Of one coordinate.
using SeesCoordinate = std::function<bool(const JointCoordinate&)>;

struct CoordinateKey {
    std::string table;
    std::string keys;  // of that table, but the one that is tried
    std::string key;
    std::string value;
    SeesCoordinate is_seen;
};

std::vector<CoordinateKey> coordinate_keys() {
    const auto friction = [](const JointCoordinate& c) { return c.friction.force == 7.0; };
    return {{"spring", "", "stiffness", "7", [](const JointCoordinate& c) { return c.stiffness == 7.0; }},
            {"spring", "", "damping", "7", [](const JointCoordinate& c) { return c.damping == 7.0; }},
            {"spring",
             "stiffness = 1, ",
             "rest",
             "\"7*t\"",
             [](const JointCoordinate& c) { return c.rest(2.0) == 14.0; }},
            {"friction", "", "moment", "7", friction},
            {"friction", "stick = 0.5, ", "force", "7", friction},
            {"friction",
             "PIN",
             "coefficient",
             "7",
             [](const JointCoordinate& c) { return c.friction.lever == 7.0; }},
            {"friction",
             "coefficient = 3.5, ",
             "radius",
             "2",
             [](const JointCoordinate& c) { return c.friction.lever == 7.0; }},
            {"friction",
             "SIZE = 7, ",
             "stick",
             "0.5",
             [](const JointCoordinate& c) { return c.friction.stick == 0.5; }},
            {"limits",
             "stiffness = 1, ",
             "lower",
             "-7",
             [](const JointCoordinate& c) { return c.limits.lower == -7.0; }},
            {"limits",
             "stiffness = 1, ",
             "upper",
             "7",
             [](const JointCoordinate& c) { return c.limits.upper == 7.0; }},
            {"limits",
             "lower = 1, ",
             "stiffness",
             "7",
             [](const JointCoordinate& c) { return c.limits.stiffness == 7.0; }},
            {"limits", "stiffness = 1, lower = 1, ", "damping", "7", [](const JointCoordinate& c) {
                 return c.limits.damping == 7.0;
             }}};
}

}  // namespace

std::vector<RoundTrip> joint_trips() {
    const std::string apart = "at_a = [1, 2, 3]\nat_b = [1, 0, 3]\n";
    const std::string crossed = "axis = [0, 2, 0]\naxis_b = [3, 0, 0]\n";
    return {
        {"joint.NAME.type",
         with_joint("ball", ""),
         [](const Problem& p) { return joint_of(p).kind == JointKind::ball; }},
        {"joint.NAME.between",
         with_joint("ball", ""),
         [](const Problem& p) { return joint_of(p).a.anchor.is_ground() && joint_of(p).b.anchor.node == 0; }},
        {"joint.NAME.at",
         with_joint("weld", "at = [1, 2, 3]\n"),
         [](const Problem& p) { return joint_of(p).b.anchor.arm == Vec3(1, 2, 3); }},
        {"joint.NAME.at_a",
         with_joint("distance", apart),
         [](const Problem& p) { return joint_of(p).a.anchor.arm == Vec3(1, 2, 3); }},
        {"joint.NAME.at_b",
         with_joint("distance", apart),
         [](const Problem& p) { return joint_of(p).b.anchor.arm == Vec3(1, 0, 3); }},
        {"joint.NAME.length",
         with_joint("distance", apart + "length = 2.0000000001\n"),
         [](const Problem& p) { return joint_of(p).length == 2.0000000001; }},
        {"joint.NAME.axis",
         with_joint("hinge", "axis = [0, 2, 0]\n"),
         [](const Problem& p) {
             return joint_of(p).a.axes.col(0) == Vec3(0, 1, 0) && joint_of(p).b.axes.col(0) == Vec3(0, 1, 0);
         }},
        {"joint.NAME.axis_b",
         with_joint("universal", crossed),
         [](const Problem& p) {
             return joint_of(p).b.axes.col(0) == Vec3(1, 0, 0) && joint_of(p).b.axes.col(1) == Vec3(0, 1, 0);
         }},
        {"joint.NAME.lead",
         with_joint("screw", "axis = [0, 2, 0]\nlead = -3\n"),
         [](const Problem& p) { return joint_of(p).lead == -3.0; }},
        {"joint.NAME.move",
         with_joint("cylinder", "axis = [0, 2, 0]\nmove = { turn = \"3*t\", slide = \"t^2\" }\n"),
         [](const Problem& p) {
             return joint_of(p).turn.motion->operator()(2.0) == 6.0 &&
                    joint_of(p).slide.motion->operator()(3.0) == 9.0;
         }},
        {"joint.NAME.drive",
         with_joint("plane", "axis = [0, 2, 0]\ndrive = \"3*t\"\n"),
         [](const Problem& p) {
             return joint_of(p).turn.drive(2.0) == 6.0 && joint_of(p).slide.drive.is_zero();
         }}};
}

std::vector<RoundTrip> gear_trips() {
    const std::string hinge = "\nbetween = [\"ground\", \"top\"]\naxis = [0, 2, 0]\n";
    const std::string deck = body_deck + "[joint.j]\ntype = \"hinge\"" + hinge +
                             "[joint.k]\ntype = \"cylinder\"" + hinge +
                             "[gear.g]\njoints = [\"j\", \"k.slide\"]\nratio = -3\n";
    return {{"gear.NAME.joints",
             deck,
             [](const Problem& p) {
                 const auto& [first, second] = p.model.gears.at(0).sides;
                 return first.joint == 0 && first.is_turn && second.joint == 1 && !second.is_turn;
             }},
            {"gear.NAME.ratio", deck, [](const Problem& p) { return p.model.gears.at(0).ratio == -3.0; }}};
}

// Without a coordinate's name of hinges and sliders, with one of cylinders.
std::vector<RoundTrip> coordinate_trips() {
    std::vector<RoundTrip> trips;
    for (const CoordinateKey& tried : coordinate_keys()) {
        for (const bool is_turn : {true, false}) {
            if (tried.key == (is_turn ? "force" : "moment") || (tried.key == "radius" && !is_turn)) continue;
            std::string keys = tried.keys + tried.key + " = " + tried.value;
            if (tried.keys == "PIN") keys.replace(0, 3, is_turn ? "radius = 1, " : "stick = 0.5, ");
            const std::size_t size = keys.find("SIZE");
            if (size != std::string::npos) keys.replace(size, 4, is_turn ? "moment" : "force");
            const auto is_seen = [=](const Problem& p) {
                return tried.is_seen(is_turn ? joint_of(p).turn : joint_of(p).slide);
            };
            const std::string name = is_turn ? "turn" : "slide";
            const std::string start = "axis = [0, 2, 0]\n" + tried.table + " = { ";
            const std::string path = "joint.NAME." + tried.table + ".";
            trips.push_back(
                {path + tried.key, with_joint(is_turn ? "hinge" : "slider", start + keys + " }\n"), is_seen});
            trips.push_back({path + name + "." + tried.key,
                             with_joint("cylinder", start + name + " = { " + keys + " } }\n"),
                             is_seen});
        }
    }
    return trips;
}

}  // namespace gxrod::test
