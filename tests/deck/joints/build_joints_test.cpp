#include <cmath>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A rod from x = 0 to 10, and bodies at (0, 0, 2) and (4, 0, 2); lines 1 to 20.
const std::string parts = rod_deck +
                          "[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [0, 0, 2]\n"
                          "[body.c]\nmass = 1\ninertia = [1, 1, 1]\nat = [4, 0, 2]\n";

// Its keys begin in line 22.
std::string joint(const std::string& lines) { return "[joint.j]\n" + lines; }

Joint read_joint(const std::string& lines) { return read(parts + joint(lines)).model.joints.at(0); }
std::string faults(const std::string& lines) { return faults_of(parts + joint(lines)); }

// A joint's first two lines.
std::string from_ground(const std::string& type) {
    return "type = \"" + type + "\"\nbetween = [\"ground\", \"b\"]\n";
}

// A coordinate with something of everything, by `name`, or by no name if that is "".
JointCoordinate read_coordinate(const std::string& type, const std::string& name, const std::string& pin) {
    const auto line = [&](const std::string& key, const std::string& value) {
        return key + " = " + (name.empty() ? value : "{ " + name + " = " + value + " }") + "\n";
    };
    const Joint built = read_joint(from_ground(type) + "axis = [0, 2, 0]\n" + line("drive", "\"3*t\"") +
                                   line("spring", "{ stiffness = 2, damping = 4, rest = \"7*t\" }") +
                                   line("friction", "{ coefficient = 3, stick = 0.5" + pin + " }") +
                                   line("limits", "{ lower = -5, upper = 6, stiffness = 8, damping = 9 }"));
    const bool is_turn = name.empty() ? built.has_turn() : name == "turn";
    CHECK((is_turn ? built.slide : built.turn).stiffness == 0.0);
    return is_turn ? built.turn : built.slide;
}

Vec3 place_of(const JointSide& side, const Model& model) { return find_place(model, side.anchor); }

}  // namespace

TEST_CASE("A joint is where the deck says, with arms from the nodes of its sides", "[deck][joint]") {
    const Problem problem =
        read(parts + joint("type = \"ball\"\nbetween = [\"r@0.25\", \"b\"]\nat = [1, 2, 3]\n"));
    const Joint& built = problem.model.joints.at(0);
    CHECK(built.name == "j");
    CHECK(problem.model.nodes[built.a.anchor.node].position == Vec3(2.5, 0, 0));  // a node of its own
    CHECK(built.a.anchor.arm == Vec3(-1.5, 2, 3));
    CHECK(built.b.anchor.node == problem.model.bodies[0].node);
    CHECK(built.b.anchor.arm == Vec3(1, 2, 1));
    CHECK(built.a.axes == Mat3::Identity());
}

TEST_CASE("Without `at` a joint is where its sides are, or at the only rod", "[deck][joint]") {
    const auto check = [](const std::string& between, const Vec3& place) {
        INFO(between);
        const Problem problem = read(parts + joint("type = \"ball\"\nbetween = [" + between + "]\n"));
        const Joint& built = problem.model.joints.at(0);
        CHECK(place_of(built.a, problem.model) == place);
        CHECK(place_of(built.b, problem.model) == place);
    };
    check("\"ground\", \"b\"", {0, 0, 2});
    check("\"r.end\", \"ground\"", {10, 0, 0});
    check("\"b\", \"r.end\"", {10, 0, 0});
    check("\"r.end\", \"b\"", {10, 0, 0});
    CHECK(
        faults("type = \"ball\"\nbetween = [\"b\", \"c\"]\n") ==
        "x.toml:23:11: joint.j.between: the points are 4 apart; expected `at`: [0, 0, 2] is where \"b\" is, "
        "[4, 0, 2] where \"c\" is");
    CHECK(faults("type = \"ball\"\nbetween = [\"r.start\", \"r.end\"]\n") ==
          "x.toml:23:11: joint.j.between: the points are 10 apart; expected `at`: [0, 0, 0] is where "
          "\"r.start\" is, [10, 0, 0] where \"r.end\" is");
}

TEST_CASE("A joint's axes begin with its own, and are right-handed", "[deck][joint]") {
    for (const char* axis : {"[0, 0, 5]", "[0, -2, 0]", "[1, 0, 0]", "[1, 2, -3]", "[1e-200, 2e-200, 0]"}) {
        INFO(axis);
        const Joint built = read_joint(from_ground("hinge") + "axis = " + axis + "\n");
        const Mat3& axes = built.a.axes;
        CHECK(axes == built.b.axes);
        CHECK((axes.transpose() * axes).isApprox(Mat3::Identity(), 1e-15));
        CHECK(std::abs(axes.determinant() - 1.0) < 1e-15);
    }
    const Joint built = read_joint(from_ground("slider") + "axis = [3, 0, 4]\n");
    CHECK(built.a.axes.col(0).isApprox(Vec3(0.6, 0, 0.8), 1e-15));
}

TEST_CASE("The axes of a universal joint's sides begin with what each carries", "[deck][joint]") {
    const Joint built = read_joint(from_ground("universal") + "axis = [0, 0, 2]\naxis_b = [3, 4, 0]\n");
    Mat3 a, b;
    a << 0, 0.6, -0.8, 0, 0.8, 0.6, 1, 0, 0;
    b << 0.6, 0, 0.8, 0.8, 0, -0.6, 0, 1, 0;
    CHECK(built.a.axes.isApprox(a, 1e-15));
    CHECK(built.b.axes.isApprox(b, 1e-15));
    CHECK(
        faults(from_ground("universal") + "axis = [0, 0, 2]\naxis_b = [0, 3, 4]\n") ==
        "x.toml:25:10: joint.j.axis_b: expected a direction at right angles to axis; the product of both, as "
        "unit vectors, is 0.8");
}

TEST_CASE("A generic joint holds what it names, in axes of A", "[deck][joint]") {
    const Joint built = read_joint(from_ground("generic") +
                                   "axis = [0, 0, 2]\ny_axis = [3, 4, 0]\nholds = [\"y\", \"rotation\"]\n");
    Mat3 axes;
    axes << 0, 0.6, -0.8, 0, 0.8, 0.6, 1, 0, 0;
    CHECK(built.a.axes.isApprox(axes, 1e-15));
    CHECK(built.b.axes == built.a.axes);
    CHECK(built.held == std::array<bool, 6>{false, true, false, true, true, true});
    CHECK(built.acts);
    CHECK_FALSE(built.strength.is_limited());
    CHECK_THAT(faults(from_ground("generic") + "axis = [0, 0, 2]\ny_axis = [0, 3, 4]\nholds = \"x\"\n"),
               Contains("joint.j.y_axis: expected a direction at right angles to axis"));
    CHECK_THAT(faults(from_ground("generic") + "axis = [0, 0, 2]\n"), Contains("joint.j.holds: missing"));
    CHECK_THAT(faults(from_ground("hinge") + "axis = [0, 0, 2]\nholds = \"x\"\n"),
               Contains("type \"hinge\" does not use this key"));
}

TEST_CASE("A joint holds in some stages, or until it breaks", "[deck][joint]") {
    const Joint built =
        read_joint("type = \"ball\"\nbetween = [\"ground\", \"b\"]\nbreaks = { force = 3, moment = 4 }\n");
    CHECK(built.strength.force == 3.0);
    CHECK(built.strength.moment == 4.0);
    const auto staged = [](const std::string& keys) {
        const std::string deck = parts + joint("type = \"ball\"\nbetween = [\"ground\", \"b\"]\n" + keys);
        return deck.substr(0, deck.find("[analysis]")) +
               deck.substr(deck.find("[", deck.find("[analysis]") + 1)) +
               "[[stage]]\nname = \"one\"\nkind = \"static\"\n[[stage]]\nname = \"two\"\nkind = "
               "\"path\"\nuntil = { t = 1 "
               "}\n";
    };
    const Problem problem = read(staged("stages = \"two\"\n"));
    CHECK_FALSE(problem.model.joints.at(0).acts);
    CHECK(problem.stages.at(1).actions.joints.at(0).acts);
    // Where it rests a support may hold what it joins.
    const std::string support = "[[support]]\nat = \"b\"\nfix = \"all\"\nstages = \"one\"\n";
    CHECK(faults_of(staged("stages = \"two\"\n" + support)).empty());
    CHECK_THAT(faults_of(staged(support)),
               Contains("a [[support]] holds all of the side that is not the ground"));
    CHECK_THAT(faults_of(staged("stages = \"too\"\n")), Contains("no stage \"too\"; did you mean \"two\"?"));
    CHECK_THAT(faults_of(staged("breaks = { force = 3 }\n")),
               Contains("a stage of kind path cannot go on from a joint that breaks"));
}

TEST_CASE("A joint breaks at a time of one stage", "[deck][joint]") {
    const auto with_stages = [](const std::string& keys, const std::string& stages) {
        const std::string deck =
            parts + joint("type = \"ball\"\nbetween = [\"ground\", \"b\"]\n" + keys + "\n");
        return deck.substr(0, deck.find("[analysis]")) +
               deck.substr(deck.find("[", deck.find("[analysis]") + 1)) + stages;
    };
    const auto stage = [](const std::string& name, const std::string& kind) {
        return "[[stage]]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\n" +
               (kind == "static" ? "" : "end_time = 2\ntime_step = 0.1\n");
    };
    const std::string one = stage("hang", "static") + stage("swing", "dynamic");
    const std::string two = one + stage("creep", "quasi-static");
    const Problem built = read(with_stages("breaks = { time = 1.5 }", one));
    CHECK_FALSE(built.model.joints.at(0).strength.time);
    CHECK(built.stages.at(1).actions.joints.at(0).strength.time == 1.5);
    const Problem named = read(with_stages("breaks = { time = 1.5, force = 3, stage = \"creep\" }", two));
    CHECK_FALSE(named.stages.at(1).actions.joints.at(0).strength.time);
    CHECK(named.stages.at(1).actions.joints.at(0).strength.force == 3.0);
    CHECK(named.stages.at(2).actions.joints.at(0).strength.time == 1.5);
    const std::string key = "joint.j.breaks.time: ";
    CHECK_THAT(faults_of(with_stages("breaks = { time = 1.5 }", two)),
               Contains(key + "the joint acts in several stages with a time, each with its own t; expected "
                              "`stage` with the name of one"));
    CHECK_THAT(faults_of(with_stages("breaks = { time = 1.5 }", stage("hang", "static"))),
               Contains(key + "the joint acts in no dynamic or quasi-static stage, and in others t is no "
                              "time; expected such a stage, or a limit of what the joint holds"));
    CHECK_THAT(faults_of(with_stages("breaks = { time = 1.5, stage = \"hang\" }", two)),
               Contains("joint.j.breaks.stage: no dynamic or quasi-static stage in which the joint acts has "
                        "the name \"hang\"; in others t is no time; expected"));
    CHECK(faults_of(with_stages("breaks = { time = 1.5 }\nstages = [\"hang\", \"creep\"]", two)).empty());
    CHECK(read(with_stages("breaks = { time = 2.5 }", one)).notes.back() ==
          "joint.j.breaks.time: the stage ends at 2, before the joint breaks at 2.5");
    CHECK_THAT(faults_of(with_stages("breaks = { time = 1 }\nclearance = { gap = 0.1, stiffness = 5 }", one)),
               Contains("a joint with clearance does not break; expected one of the two"));
}

TEST_CASE("A free joint does something", "[deck][joint]") {
    const std::string free = from_ground("free") + "axis = [0, 0, 1]\n";
    CHECK(faults(free) ==
          "x.toml:22:8: joint.j.type: a free joint on which nothing acts does nothing; expected move, drive, "
          "spring, friction or limits");
    CHECK(faults(free + "move = \"t\"\n") ==
          "x.toml:25:8: joint.j.move: a free joint has a turn and a slide; expected move = { turn = … }, { "
          "slide "
          "= … } or both");
    for (const char* action : {"move = { turn = \"t^2\", slide = \"t^2\" }",
                               "drive = { slide = 2 }",
                               "spring = { turn = { damping = 1 } }",
                               "friction = { slide = { force = 1 } }",
                               "limits = { turn = { lower = -1, stiffness = 2 } }"}) {
        INFO(action);
        const Joint built = read_joint(free + action + "\n");
        CHECK(built.kind == JointKind::free);
        CHECK(built.has_turn());
        CHECK(built.has_slide());
    }
}

TEST_CASE("Sides that cannot move against each other are errors", "[deck][joint]") {
    const auto of = [](const std::string& between) {
        return faults("type = \"ball\"\nbetween = [" + between + "]\n");
    };
    CHECK(
        of("\"r.end\", \"r.end\"") ==
        "x.toml:23:11: joint.j.between: both sides are \"r.end\"; expected two points that can move against "
        "each other");
    CHECK(
        of("\"r.end\", \"r@1\"") ==
        "x.toml:23:11: joint.j.between: \"r.end\" and \"r@1\" are one node, which a [[connect]] or the `at` "
        "of a body makes rigid; expected two nodes");
    CHECK(of("\"ground\", \"ground\"") ==
          "x.toml:23:11: joint.j.between: both sides are the ground; expected a point that moves, too");
    CHECK(of("\"ground\", \"bb\"") ==
          "x.toml:23:22: joint.j.between[1]: no point \"bb\"; the deck has r.start, r.end, b, c");
    CHECK(of("\"grond\", \"b\"") ==
          "x.toml:23:12: joint.j.between[0]: no point \"grond\"; did you mean \"ground\"?");
    const std::string connected = replaced(parts, "[body.c]", "[body.d]\nmass = 1\nat = \"r.end\"\n[body.c]");
    CHECK(
        faults_of(connected + joint("type = \"ball\"\nbetween = [\"r.end\", \"d\"]\n")) ==
        "x.toml:26:11: joint.j.between: \"r.end\" and \"d\" are one node, which a [[connect]] or the `at` of "
        "a body makes rigid; expected two nodes");
    const std::string clamp = "[[support]]\nat = \"r.end\"\nfix = \"all\"\n";
    CHECK(
        faults_of(parts + clamp + joint("type = \"ball\"\nbetween = [\"ground\", \"r.end\"]\n")) ==
        "x.toml:26:11: joint.j.between: a [[support]] holds all of the side that is not the ground; expected "
        "a side that is free to move");
    const std::string both = clamp + "[[support]]\nat = \"b\"\nfix = \"all\"\n";
    CHECK(faults_of(parts + both + joint("type = \"ball\"\nbetween = [\"b\", \"r.end\"]\n")) ==
          "x.toml:29:11: joint.j.between: supports hold all of both sides; expected a side that is free to "
          "move");
    CHECK(faults_of(parts + clamp + joint("type = \"ball\"\nbetween = [\"b\", \"r.end\"]\n")).empty());
}

TEST_CASE("A type has its own keys", "[deck][joint]") {
    const std::string axis = "axis = [0, 0, 1]\n";
    CHECK(
        faults(from_ground("hinge")) ==
        "x.toml:21:1: joint.j.axis: missing; expected an array of 3 numbers or expressions; the direction of "
        "its axis at t = 0, global");
    CHECK(faults(from_ground("hinge") + "axis = [0, 0, 0]\n") ==
          "x.toml:24:8: joint.j.axis: has no length; expected a direction");
    CHECK(
        faults(from_ground("ball") + axis) ==
        "x.toml:24:1: joint.j.axis: type \"ball\" does not use this key; it is for hinge, cylinder, slider, "
        "universal, screw, plane, free, generic, cam");
    CHECK(
        faults(from_ground("ball") + "move = \"t\"\n") ==
        "x.toml:24:1: joint.j.move: type \"ball\" does not use this key; it is for hinge, cylinder, slider, "
        "universal, screw, plane, free, sleeve");
    CHECK(faults(from_ground("universal") + axis) ==
          "x.toml:21:1: joint.j.axis_b: missing; expected an array of 3 numbers or expressions; the axis "
          "that B "
          "carries");
    CHECK(faults(from_ground("hinge") + axis + "axis_b = [1, 0, 0]\n") ==
          "x.toml:25:1: joint.j.axis_b: type \"hinge\" does not use this key; it is for universal");
    CHECK(faults(from_ground("screw") + axis) ==
          "x.toml:21:1: joint.j.lead: missing; expected a number or an expression; the slide in one turn");
    CHECK(faults(from_ground("screw") + axis + "lead = 0\n") ==
          "x.toml:25:8: joint.j.lead: a screw of lead 0 does not slide; expected a hinge, or another lead");
    CHECK(faults(from_ground("hinge") + axis + "length = 2\n") ==
          "x.toml:25:1: joint.j.length: type \"hinge\" does not use this key; it is for distance");
    CHECK(faults(from_ground("hinge") + axis + "at_a = [0, 0, 0]\n") ==
          "x.toml:25:1: joint.j.at_a: type \"hinge\" does not use this key; it is for distance, cam");
    CHECK(faults("between = [\"ground\", \"b\"]\n")
              .starts_with("x.toml:21:1: joint.j.type: missing; expected"));
    CHECK(faults(from_ground("revolute") + axis).find("did you mean \"hinge\"?") != std::string::npos);
    CHECK(faults(from_ground("hinge") + axis + "torque = 1\n") ==
          "x.toml:25:1: joint.j.torque: unknown key; did you mean \"drive\"?");
}

TEST_CASE("A distance is between two places", "[deck][joint]") {
    const Problem problem =
        read(parts + joint("type = \"distance\"\nbetween = [\"b\", \"c\"]\nat_b = [4, 3, 2]\n"));
    const Joint& built = problem.model.joints.at(0);
    CHECK(built.length == 5.0);
    CHECK(built.b.anchor.arm == Vec3(0, 3, 0));
    const Joint given = read_joint(from_ground("distance") + "at_a = [0, 0, 4]\nlength = 2.0000000001\n");
    CHECK(given.length == 2.0000000001);
    CHECK(given.a.anchor.arm == Vec3(0, 0, 4));
    CHECK(faults(from_ground("distance")) ==
          "x.toml:23:12: joint.j.between[0]: the ground has no place of its own; expected at_a = [x, y, z]");
    CHECK(
        faults(from_ground("distance") + "at_a = [0, 0, 2]\n") ==
        "x.toml:23:11: joint.j.between: the points are at one place, where their distance has no direction; "
        "expected points apart, or a ball");
    CHECK(faults(from_ground("distance") + "at_a = [0, 0, 4]\nlength = 3\n") ==
          "x.toml:25:10: joint.j.length: the points are 2 apart at t = 0; expected this length, or none");
}

TEST_CASE("What acts on a coordinate is that of a joint's own, or of the one that it names",
          "[deck][joint]") {
    const std::string axis = "axis = [0, 0, 1]\n";
    const auto hinge = [&](const std::string& lines) { return from_ground("hinge") + axis + lines; };
    const auto cylinder = [&](const std::string& lines) { return from_ground("cylinder") + axis + lines; };
    const auto screw = [&](const std::string& lines) {
        return from_ground("screw") + axis + "lead = 2\n" + lines;
    };
    CHECK(read_joint(hinge("move = { turn = \"t\" }\n")).turn.motion->operator()(3.0) == 3.0);
    CHECK(read_joint(from_ground("slider") + axis + "move = \"t\"\n").slide.motion->operator()(3.0) == 3.0);
    CHECK(faults(hinge("move = { slide = \"t\" }\n")) ==
          "x.toml:25:18: joint.j.move.slide: a hinge has no slide");
    CHECK(faults(hinge("move = { trun = \"t\" }\n")) ==
          "x.toml:25:10: joint.j.move.trun: unknown key; did you mean \"turn\"?");
    CHECK(faults(hinge("spring = { slide = { stiffness = 1 } }\n")) ==
          "x.toml:25:20: joint.j.spring.slide: a hinge has no slide");
    CHECK(faults(cylinder("drive = \"t\"\n")) ==
          "x.toml:25:9: joint.j.drive: a cylinder has a turn and a slide; expected drive = { turn = … }, { "
          "slide "
          "= … } or both");
    CHECK(faults(cylinder("spring = { stiffness = 1 }\n")) ==
          "x.toml:25:10: joint.j.spring: a cylinder has a turn and a slide; expected spring = { turn = { … } "
          "}, "
          "{ slide = { … } } or both");
    CHECK(faults(cylinder("spring = { stiffness = 1, turn = { stiffness = 1 } }\n")) ==
          "x.toml:25:24: joint.j.spring.stiffness: belongs into turn or slide, where this table has these");
    CHECK(faults(cylinder("move = { turn = \"t\" }\ndrive = { slide = 1 }\n")).empty());
    CHECK(faults(hinge("move = \"t\"\ndrive = 1\n")) ==
          "x.toml:26:9: joint.j.drive: `move` says what the turn is, whatever drives it; expected one of the "
          "two");
    const Joint moved = read_joint(screw("move = { slide = \"t\" }\n"));
    CHECK(std::abs(moved.turn.motion->operator()(3.0) - 3.0 * M_PI) < 1e-14);
    CHECK_FALSE(moved.slide.motion);
    CHECK(moved.lead == 2.0);
    CHECK(
        faults(screw("move = { turn = \"t\", slide = \"t\" }\n")) ==
        "x.toml:26:30: joint.j.move.slide: the turn of a screw says what its slide is; expected one of them");
}

TEST_CASE("A coordinate is acted on by the deck's numbers, whether the deck names it or not",
          "[deck][joint]") {
    const auto check = [](const JointCoordinate& built, double lever) {
        CHECK_FALSE(built.motion);
        CHECK(built.drive(2.0) == 6.0);
        CHECK(built.stiffness == 2.0);
        CHECK(built.damping == 4.0);
        CHECK(built.rest(2.0) == 14.0);
        CHECK(built.friction.force == 0.0);
        CHECK(built.friction.lever == lever);
        CHECK(built.friction.stick == 0.5);
        CHECK(built.limits.lower == -5.0);
        CHECK(built.limits.upper == 6.0);
        CHECK(built.limits.stiffness == 8.0);
        CHECK(built.limits.damping == 9.0);
    };
    for (const auto& [type, name] : {std::pair{"hinge", ""}, {"hinge", "turn"}, {"cylinder", "turn"}})
        check(read_coordinate(type, name, ", radius = 0.5"), 1.5);
    for (const auto& [type, name] : {std::pair{"slider", ""}, {"slider", "slide"}, {"cylinder", "slide"}})
        check(read_coordinate(type, name, ""), 3.0);
}

TEST_CASE("Frictions and limits that cannot be are errors", "[deck][joint]") {
    const auto hinge = [&](const std::string& lines) {
        return faults(from_ground("hinge") + "axis = [0, 0, 1]\n" + lines);
    };
    CHECK(hinge("friction = { moment = -1 }\n") ==
          "x.toml:25:23: joint.j.friction.moment: expected a number at least 0, found -1");
    CHECK(hinge("friction = { force = 1 }\n") ==
          "x.toml:25:22: joint.j.friction.force: the friction of a turn is a moment");
    CHECK(hinge("friction = { moment = 1, stick = 0 }\n") ==
          "x.toml:25:34: joint.j.friction.stick: expected a number greater than 0, found 0");
    CHECK(hinge("friction = { coefficient = 0.2 }\n") ==
          "x.toml:25:12: joint.j.friction.radius: missing; expected the radius of the pin, a number greater "
          "than "
          "0 or an expression");
    CHECK(hinge("friction = { moment = 1, radius = 2 }\n") ==
          "x.toml:25:26: joint.j.friction.radius: goes with coefficient, and this table has moment");
    CHECK(
        faults(from_ground("slider") + "axis = [0, 0, 1]\nfriction = { coefficient = 0.2, radius = 1 }\n") ==
        "x.toml:25:42: joint.j.friction.radius: only the friction of a turn has a radius");
    CHECK(faults(from_ground("free") + "axis = [0, 0, 1]\nfriction = { slide = { coefficient = 0.2 } }\n") ==
          "x.toml:25:38: joint.j.friction.slide.coefficient: a free joint holds no force; expected moment or "
          "force");
    CHECK(hinge("limits = { lower = 2, upper = 1, stiffness = 1 }\n") ==
          "x.toml:25:20: joint.j.limits.lower: 2 is above upper, 1");
    CHECK(hinge("limits = { lower = 0 }\n").empty());
    CHECK_THAT(hinge("limits = { lower = 0.2, upper = 1 }\n"),
               Contains("joint.j.limits.lower: 0.2 is above 0, the turn at t = 0, where a stop would jump"));
    CHECK_THAT(hinge("limits = { upper = -0.2 }\n"), Contains("joint.j.limits.upper: -0.2 is below 0"));
    CHECK_THAT(hinge("limits = { lower = 0, upper = 0 }\n"),
               Contains("joint.j.limits.stiffness: missing; the turn has no range between the stops"));
    CHECK_THAT(hinge("move = \"t^2\"\nlimits = { upper = 1 }\n"),
               Contains("joint.j.limits.stiffness: missing; `move` says what the turn is"));
    CHECK_THAT(hinge("limits = { upper = 1, damping = 1 }\n"), Contains("a stop has no damping"));
    CHECK(hinge("spring = { rest = 1 }\n")
              .starts_with("x.toml:25:10: joint.j.spring: missing; expected stiffness or damping"));
}

TEST_CASE("Friction gives way by a small part of the model", "[deck][joint]") {
    const auto stick = [](const std::string& type, const std::string& friction) {
        return read_joint(from_ground(type) + "axis = [0, 0, 1]\nfriction = { " + friction + " = 2 }\n");
    };
    CHECK(stick("hinge", "moment").turn.friction.stick == 1e-4);
    CHECK(stick("hinge", "moment").turn.friction.force == 2.0);
    CHECK(stick("slider", "force").slide.friction.stick == 1e-5 * Vec3(10, 0, 2).norm());
}

TEST_CASE("A motor begins at 0, and does not jump", "[deck][joint]") {
    const auto motor = [](const std::string& move) {
        return faults(from_ground("hinge") + "axis = [0, 0, 1]\nmove = " + move + "\n");
    };
    CHECK(motor("\"sin(t)\"").empty());
    CHECK(
        motor("\"1 + t\"") ==
        "x.toml:25:8: joint.j.move: is 1 at t = 0; expected 0 there, since the deck says where things are at "
        "t = 0");
    CHECK(motor("\"t < 0.25 ? 0 : 1\"")
              .starts_with("x.toml:25:8: joint.j.move: jumps from 0 to 1 at t = 0.25; expected"));
    CHECK(motor("\"1/(t - 0.5)\"").starts_with("x.toml:25:8: joint.j.move: "));
    CHECK(
        faults(from_ground("hinge") + "axis = [0, 0, 1]\nspring = { stiffness = 1, rest = \"1/(t-0.5)\" }\n")
            .starts_with("x.toml:25:34: joint.j.spring.rest: "));
}

TEST_CASE("Each stage has its own t for what acts on joints", "[deck][joint]") {
    const std::string staged = replaced(replaced(parts, "[analysis]", "[[stage]]\nname = \"one\""),
                                        "kind = \"dynamic\"\nend_time = "
                                        "1.0\nsteps = 10",
                                        "kind = \"static\"") +
                               "[[stage]]\nname = \"two\"\nkind = \"dynamic\"\nend_time = 1\nsteps = 10\n";
    const Problem problem = read(staged + joint("type = \"hinge\"\nbetween = [\"ground\", \"b\"]\n"
                                                "axis = [0, 0, 1]\ndrive = 3\n"));
    CHECK(problem.model.joints.at(0).turn.drive(0.5) == 1.5);  // grows
    *problem.stages[1].end = 0.0;
    REQUIRE(problem.stages[1].actions.joints.size() == 1);
    CHECK(problem.stages[1].actions.joints[0].turn.drive(0.5) == 3.0);  // stays
}

TEST_CASE("Histories of joints have their quantities", "[deck][joint]") {
    const std::string deck = parts + joint(from_ground("hinge") + "axis = [0, 0, 1]\n");
    const auto history = [](const std::string& at, const std::string& quantities) {
        return "[[history]]\nname = \"h\"\nat = \"" + at + "\"\nquantities = " + quantities + "\n";
    };
    const Problem problem =
        read(deck + history("j", "[\"angle\", \"angle_rate\", \"force\", \"moment_a\", \"gap\"]"));
    CHECK(is_tie(problem.output.histories[0].target, TieKind::joint));
    CHECK(std::get<WatchedTie>(problem.output.histories[0].target).index == 0);
    const auto message = [&](const std::string& at, const std::string& quantity) {
        const std::string text = faults_of(deck + history(at, "\"" + quantity + "\""));
        return text.substr(text.find("\": ") + 3);
    };
    CHECK(message("j", "position") == "only points have it; this is a joint");
    CHECK(message("j", "elongation") == "only springs have it; this is a joint");
    CHECK(message("b", "angle") == "only joints have it; this is a point");
    CHECK(message("b", "force") == "only points of rods have it; this one is a body");
    CHECK(message("j", "slide") == "this joint has no slide");
    CHECK(faults_of(deck + history("j", "[\"drive\", \"friction\"]")).empty());  // zero
    CHECK(faults_of(deck + history("jj", "\"angle\"")).find("no point \"jj\"") != std::string::npos);
    const std::string moved =
        parts + joint(from_ground("cylinder") + "axis = [0, 0, 1]\nmove = { turn = \"t\", slide = \"t\" }\n");
    const std::string text = faults_of(moved + history("j", "\"drive\""));
    CHECK(text.find("this joint has two motors") != std::string::npos);
}

TEST_CASE("A sleeve has its place on the rod", "[deck][joint][sleeve]") {
    const Problem problem = read(
        parts + joint("type = \"sleeve\"\nbetween = [\"r\", \"b\"]\nat = [2.5, 0, 0]\nmove = \"t^2\"\n"));
    CHECK(problem.model.joints.empty());
    const Sleeve& sleeve = problem.model.sleeves.at(0);
    CHECK(sleeve.name == "j");
    CHECK(sleeve.rod == 0);
    CHECK(sleeve.place == Approx(2.5));
    CHECK(sleeve.point.node == problem.model.bodies[0].node);
    CHECK((sleeve.point.arm - Vec3(2.5, 0, -2)).norm() < 1e-14);
    CHECK((*sleeve.slide.motion)(0.5) == 0.25);
    const Sleeve eye =
        read(parts + joint("type = \"sleeve\"\nbetween = [\"r\", \"ground\"]\nat = [4, 0, 0]\n"))
            .model.sleeves.at(0);
    CHECK(eye.point.is_ground());
    CHECK((eye.point.arm - Vec3(4, 0, 0)).norm() < 1e-14);
    CHECK(eye.place == Approx(4.0));
}

TEST_CASE("A sleeve is between a rod and a point of another part", "[deck][joint][sleeve]") {
    const auto message = [](const std::string& between, const std::string& more = "") {
        const std::string text = faults("type = \"sleeve\"\nbetween = [" + between + "]\n" + more);
        return text.substr(text.find(": ", 20) + 2);
    };
    CHECK(message("\"r\", \"b\"") ==
          "the point is 2 from rod r; expected a point on it: the nearest is [0, 0, 0]");
    CHECK(message("\"r\", \"b\"", "at = [0, 1, 0]\n") ==
          "the point is 1 from rod r; expected a point on it: the nearest is [0, 0, 0]");
    const std::string what = "; a sleeve is between a rod and the point that slides along it";
    CHECK_THAT(message("\"b\", \"r.end\""), Contains("no rod \"b\"") && Contains(what));
    CHECK_THAT(message("\"r.end\", \"b\""), Contains("no rod \"r.end\"; did you mean \"r\"?" + what));
    CHECK_THAT(message("\"r\", \"r.end\""),
               Contains("\"r.end\" is a point of rod r, which cannot slide along itself; expected a point of "
                        "another part"));
    CHECK_THAT(message("\"r\", \"ground\""),
               Contains("the ground has no place of its own; expected at = [x, y, z]"));
    const std::string friction = "at = [1, 0, 0]\nfriction = { coefficient = 0.1, radius = 2 }\n";
    CHECK_THAT(message("\"r\", \"b\"", friction), Contains("only the friction of a turn has a radius"));
    const std::string gear =
        "at = [1, 0, 0]\n[joint.k]\ntype = \"hinge\"\nbetween = [\"ground\", \"c\"]\naxis = [1, 0, 0]\n"
        "[gear.g]\njoints = [\"j\", \"k\"]\nratio = 1\n";
    CHECK_THAT(message("\"r\", \"b\"", gear), Contains("a gear cannot tie the slide of a sleeve"));
}

TEST_CASE("A sleeve slides along a rod that is one line", "[deck][joint][sleeve]") {
    const std::string ring =
        "[section.s]\nstiffness = { EA = 1, GAy = 1, GAz = 1, GJ = 1, EIy = 1, EIz = 1 }\n"
        "inertia = { rhoA = 1, rhoIy = 1, rhoIz = 1 }\n"
        "[rod.r]\nsection = \"s\"\narc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1, 0, 0], angle = "
        "\"2*pi\" "
        "}\nelements = 8\n[[connect]]\npoints = [\"r.start\", \"r.end\"]\n"
        "[joint.j]\ntype = \"sleeve\"\nbetween = [\"r\", \"ground\"]\nat = [-1, 0, 0]\n"
        "[analysis]\nkind = \"dynamic\"\nend_time = 1\nsteps = 10\n";
    CHECK_THAT(faults_of(ring),
               Contains("rod r branches or comes back to its start; expected a rod that is one line"));
}

TEST_CASE("A joint's name is no point's", "[deck][joint]") {
    CHECK(faults_of(parts + "[joint.b]\ntype = \"ball\"\nbetween = [\"b\", \"r.end\"]\n") ==
          "x.toml:21:1: joint.b: body.b has this name too, and points go by it");
}

TEST_CASE("A distance that can be slack is at most its length", "[deck][joint]") {
    const auto rope = [](const std::string& keys) {
        return "type = \"distance\"\nbetween = [\"ground\", \"b\"]\nat_a = [0, 0, 0]\n" + keys;
    };
    const Joint built = read_joint(rope("length = 3\nslack = true\n"));
    CHECK(built.pulls_only);
    CHECK(built.length == 3.0);
    CHECK(read_joint(rope("slack = true\n")).length == 2.0);
    CHECK_FALSE(read_joint(rope("")).pulls_only);
    CHECK_THAT(faults(rope("length = 1\nslack = true\n")),
               Contains("joint.j.length: the points are 2 apart at t = 0; expected at least this length"));
    CHECK_THAT(faults(from_ground("ball") + "slack = true\n"), Contains("does not use this key"));
    const std::string analysis =
        "[analysis]\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\nintegrator = "
        "\"runge-kutta-4\"\n";
    std::string deck = parts.substr(0, parts.find("[analysis]")) +
                       parts.substr(parts.find("[", parts.find("[analysis]") + 1)) + analysis;
    CHECK_THAT(faults_of(deck + joint(rope("slack = true\n"))),
               Contains("joint.j.slack: a joint cannot become taut in runge-kutta-4, an explicit scheme"));
    CHECK_THAT(faults_of(deck + joint(from_ground("hinge") + "axis = [0, 0, 1]\nlimits = { upper = 1 }\n")),
               Contains("joint.j.limits: without stiffness they cannot begin to hold in runge-kutta-4"));
}

TEST_CASE("A clearance has the contact that the deck says", "[deck][joint]") {
    const auto hinge = [](const std::string& clearance, const std::string& more = "") {
        return from_ground("hinge") + "axis = [0, 0, 1]\nclearance = { " + clearance + " }\n" + more;
    };
    const Joint built = read_joint(hinge(
        "gap = 2e-3, stiffness = 5, exponent = 1.5, restitution = 0.8, impact_speed = 3, friction = 0.2, "
        "radius = 0.4, slip_speed = 7"));
    REQUIRE(built.clearance);
    CHECK(built.clearance->contact.upper == 2e-3);
    CHECK_FALSE(built.clearance->contact.lower);
    CHECK(built.clearance->contact.stiffness == 5.0);
    CHECK(built.clearance->contact.exponent == 1.5);
    CHECK(built.clearance->contact.damping == 0.0);
    CHECK(built.clearance->contact.hysteresis == Approx(0.75 * 0.36 / 3.0));
    CHECK(built.clearance->friction == 0.2);
    CHECK(built.clearance->radius == 0.4);
    CHECK(built.clearance->slip_speed == 7.0);
    CHECK(read_joint(hinge("gap = 1, stiffness = 5, damping = 6")).clearance->contact.damping == 6.0);
    CHECK_FALSE(read_joint(from_ground("hinge") + "axis = [0, 0, 1]\n").clearance);

    const auto message = [&](const std::string& clearance, const std::string& more = "") {
        return faults(hinge(clearance, more));
    };
    const std::string at = "x.toml:25:13: joint.j.clearance.";
    CHECK(message("gap = 1") ==
          at + "stiffness: missing; expected a number greater than 0 or an expression; of the contact");
    CHECK(
        message("gap = 1, stiffness = 5, restitution = 0.9") ==
        at + "impact_speed: missing; expected the speed of impact for which `restitution` is given, a number "
             "greater than 0");
    CHECK(message("gap = 1, stiffness = 5, friction = 0.1, radius = 1") ==
          at + "slip_speed: missing; expected the speed of slip at which friction has 0.7 of its limit, a "
               "number greater than 0");
    CHECK_THAT(message("gap = 1, stiffness = 5, radius = 1"),
               Contains("clearance.radius: goes with friction, which this table has not"));
    CHECK_THAT(message("gap = 1, stiffness = 5, damping = 1, restitution = 0.9, impact_speed = 1"),
               Contains("damping is given too; only one of them can be"));
    CHECK_THAT(message("gap = 1, stiffness = 5", "breaks = { force = 3 }\n"),
               Contains("joint.j.breaks: a joint with clearance does not break; expected one of the two"));
    CHECK_THAT(
        message("gap = 1, stiffness = 5", "friction = { coefficient = 0.2, radius = 0.01 }\n"),
        Contains("the joint has a clearance, whose contact carries the force; expected `friction` there"));
    CHECK_THAT(faults(from_ground("weld") + "clearance = { gap = 1, stiffness = 5 }\n"),
               Contains("type \"weld\" does not use this key; it is for ball, hinge, cylinder"));
}

}  // namespace gxrod::test
