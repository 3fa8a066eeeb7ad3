#include <cmath>
#include <set>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/schema.hpp"
#include "model/spring_law.hpp"
#include "tools/catch.hpp"

// Every key of the schema, set to a value that is not its default, is seen in the problem that the reader
// builds.
namespace gxrod::test {
namespace {

PathSettings path_of(const Problem& p) {
    const auto* path = std::get_if<PathSettings>(&p.analysis);
    return path != nullptr ? *path : PathSettings{};
}

AdaptiveSettings adaptive_of(const Problem& p) { return dynamic_of(p).adaptive.value_or(AdaptiveSettings{}); }

std::string with_body_key(const std::string& line) {
    return replaced(body_deck, "[analysis]", line + "\n[analysis]");
}
std::string with_rod_key(const std::string& line) {
    return replaced(rod_deck, "[analysis]", line + "\n[analysis]");
}
std::string with_history(const std::string& line) {
    const std::string rest = "name = \"h\"\nat = \"r.end\"\nquantities = \"position\"\n";
    const std::string key = line.substr(0, line.find(' '));
    const std::size_t at = rest.find(key + " =");
    if (at == std::string::npos) return rod_deck + "[[history]]\n" + rest + line;
    return rod_deck + "[[history]]\n" + std::string(rest).replace(at, rest.find('\n', at) - at, line);
}

const std::string force = "[[load]]\nat = \"r.end\"\nforce = [\"2*t\", 0, 3]\n";

std::vector<RoundTrip> spring_trips() {
    const auto with = [](const std::string& lines) {
        return body_deck + "[spring.s]\nat_a = [1, 2, 3]\n" + lines;
    };
    const auto spring = [](const Problem& p) { return p.model.springs[0]; };
    const std::string between = "between = [\"ground\", \"top\"]\n";
    return {{"spring.NAME.between",
             with(between + "stiffness = 1\n"),
             [=](const Problem& p) { return spring(p).ends[0].is_ground() && spring(p).ends[1].node == 0; }},
            {"spring.NAME.at_a",
             with(between + "stiffness = 1\n"),
             [=](const Problem& p) { return spring(p).ends[0].arm == Vec3(1, 2, 3); }},
            {"spring.NAME.at_b",
             with(between + "at_b = [4, 5, 6]\nstiffness = 1\n"),
             [=](const Problem& p) { return spring(p).ends[1].arm == Vec3(4, 5, 6); }},
            {"spring.NAME.stiffness",
             with(between + "stiffness = 7\n"),
             [=](const Problem& p) { return spring(p).stiffness == 7.0; }},
            {"spring.NAME.damping",
             with(between + "damping = 7\n"),
             [=](const Problem& p) { return spring(p).damping == 7.0; }},
            {"spring.NAME.force",
             with(between + "force = \"length + 7*rate\"\n"),
             [=](const Problem& p) {
                 return spring(p).law && spring(p).law->has_rate() && (*spring(p).law)(2.0, 3.0) == 23.0;
             }},
            {"spring.NAME.length", with(between + "stiffness = 1\nlength = 7\n"), [=](const Problem& p) {
                 return spring(p).length == 7.0;
             }}};
}

std::vector<RoundTrip> bushing_trips() {
    const auto with = [](const std::string& lines) { return body_deck + "[bushing.b]\n" + lines; };
    const auto bushing = [](const Problem& p) { return p.model.bushings[0]; };
    const std::string between = "between = [\"ground\", \"top\"]\n";
    const std::string matrix =
        "_matrix = [[1,0,0,0,0,0],[0,2,0,0,0,1],[0,0,3,0,0,0],[0,0,0,4,0,0],[0,0,0,0,5,0],[0,1,0,0,0,6]]\n";
    std::vector<RoundTrip> trips{
        {"bushing.NAME.between",
         with(between + "stiffness = { x = 1 }\n"),
         [=](const Problem& p) { return bushing(p).ends[0].is_ground() && bushing(p).ends[1].node == 0; }},
        {"bushing.NAME.at",
         with(between + "at = [1, 2, 3]\nstiffness = { x = 1 }\n"),
         [=](const Problem& p) { return bushing(p).ends[0].arm == Vec3(1, 2, 3); }},
        {"bushing.NAME.axes",
         with(between + "axes = [[0, 1, 0], [0, 0, 1], [1, 0, 0]]\nstiffness = { x = 1 }\n"),
         [=](const Problem& p) { return (bushing(p).axes * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-15; }},
        {"bushing.NAME.stiffness_matrix",
         with(between + "stiffness" + matrix),
         [=](const Problem& p) {
             return bushing(p).stiffness(1, 5) == 1.0 && bushing(p).stiffness(4, 4) == 5.0;
         }},
        {"bushing.NAME.damping_matrix", with(between + "damping" + matrix), [=](const Problem& p) {
             return bushing(p).damping(1, 5) == 1.0 && bushing(p).damping(4, 4) == 5.0;
         }}};
    for (int i = 0; i < 6; ++i) {
        const std::string name(component_names[i]);
        for (const bool is_stiffness : {true, false}) {
            const std::string key = is_stiffness ? "stiffness" : "damping";
            trips.push_back({"bushing.NAME." + key + "." + name,
                             with(between + key + " = { " + name + " = 7 }\n"),
                             [=](const Problem& p) {
                                 const Bushing b = bushing(p);
                                 return (is_stiffness ? b.stiffness : b.damping)(i, i) == 7.0;
                             }});
        }
    }
    return trips;
}

// body_deck with a joint of this type from the ground to its body.
std::string with_joint(const std::string& type, const std::string& lines) {
    return body_deck + "[joint.j]\ntype = \"" + type + "\"\nbetween = [\"ground\", \"top\"]\n" + lines;
}

Joint joint_of(const Problem& p) { return p.model.joints.at(0); }

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

std::vector<RoundTrip> top_level_trips() {
    return {
        {"title",
         "title = \"A title\"\n" + body_deck,
         [](const Problem& p) { return p.record.title == "A title"; }},
        {"units",
         "units = \"mm t s\"\n" + body_deck,
         [](const Problem& p) { return p.record.units == "mm t s"; }},
        {"gravity",
         "gravity = [1, \"2\", -9.5]\n" + body_deck,
         [](const Problem& p) { return p.model.gravity(0.0) == Vec3(1, 2, -9.5); }},
        {"parameters",
         replaced(body_deck, "mass = 1.0", "mass = \"2*m\"") + "[parameters]\nm = 4\n",
         [](const Problem& p) { return p.model.bodies[0].mass == 8.0; }},
        {"input.NAME.value",
         body_deck + "[input.u]\nvalue = \"3*t\"\n",
         [](const Problem& p) { return !p.model.inputs.empty() && (*p.model.inputs[0])(2.0) == 6.0; }},
        {"input.NAME.hold",
         body_deck + "[input.u]\nhold = \"linear\"\n",
         [](const Problem& p) {
             return !p.model.inputs.empty() && p.model.inputs[0]->hold() == InputHold::linear;
         }},
        {"function.NAME.table",
         body_deck +
             "[function.f]\ntable = [[0, 0], [2, 6]]\n[[load]]\nat = \"top\"\nforce = [\"f(t)\", 0, 0]\n",
         [](const Problem& p) { return p.model.loads[0].force[0](1.0) == 3.0; }},
        {"function.NAME.file",
         body_deck + "[function.f]\nfile = \"" GXROD_SOURCE_DIR
                     "/tests/deck/motion.csv\"\n[[load]]\nat = \"top\"\nforce = [\"f(t)\", 0, 0]\n",
         [](const Problem& p) { return p.model.loads[0].force[0](1.5) == 5.0; }},
        {"function.NAME.columns",
         body_deck + "[function.f]\nfile = \"" GXROD_SOURCE_DIR
                     "/tests/deck/motion.csv\"\ncolumns = [\"t\", 3]\n[[load]]\nat = \"top\"\n"
                     "force = [\"f(t)\", 0, 0]\n",
         [](const Problem& p) { return p.model.loads[0].force[0](1.5) == 2.5; }},
        {"function.NAME.interpolation",
         body_deck + "[function.f]\ntable = [[0, 0], [1, 1], [3, 9]]\ninterpolation = \"cubic\"\n"
                     "[[load]]\nat = \"top\"\nforce = [\"f(t)\", 0, 0]\n",
         [](const Problem& p) { return std::abs(p.model.loads[0].force[0](2.0) - 4.0) < 1e-14; }},
        {"function.NAME.expression",
         body_deck + "[function.f]\nexpression = \"t^2\"\n[[load]]\nat = \"top\"\nforce = [\"f(t)\", 0, 0]\n",
         [](const Problem& p) { return p.model.loads[0].force[0](3.0) == 9.0; }}};
}

std::vector<RoundTrip> section_trips() {
    const auto stiffness = [](int i, double value) {
        return [=](const Problem& p) { return p.model.sections[0].stiffness(i, i) == value; };
    };
    const auto mass = [](int i, double value) {
        return [=](const Problem& p) { return p.model.sections[0].mass(i, i) == value; };
    };
    return {{"section.NAME.stiffness.EA", replaced(rod_deck, "EA = 1e4", "EA = 77"), stiffness(0, 77)},
            {"section.NAME.stiffness.GAy", replaced(rod_deck, "GAy = 2e4", "GAy = 77"), stiffness(1, 77)},
            {"section.NAME.stiffness.GAz", replaced(rod_deck, "GAz = 3e4", "GAz = 77"), stiffness(2, 77)},
            {"section.NAME.stiffness.GJ", replaced(rod_deck, "GJ = 500", "GJ = 77"), stiffness(3, 77)},
            {"section.NAME.stiffness.EIy", replaced(rod_deck, "EIy = 600", "EIy = 77"), stiffness(4, 77)},
            {"section.NAME.stiffness.EIz", replaced(rod_deck, "EIz = 700", "EIz = 77"), stiffness(5, 77)},
            {"section.NAME.inertia.rhoA",
             replaced(rod_deck, "rhoA = 1.0", "rhoA = 7"),
             [](const Problem& p) { return p.model.sections[0].mass.diagonal().head<3>() == Vec3(7, 7, 7); }},
            {"section.NAME.inertia.rhoJ", replaced(rod_deck, "rhoJ = 20", "rhoJ = 77"), mass(3, 77)},
            {"section.NAME.inertia.rhoIy", replaced(rod_deck, "rhoIy = 10", "rhoIy = 77"), mass(4, 77)},
            {"section.NAME.inertia.rhoIz", replaced(rod_deck, "rhoIz = 11", "rhoIz = 77"), mass(5, 77)}};
}

// rod_deck with other keys for its section's stiffness and inertia.
std::string with_shape(const std::string& shape, const std::string& material) {
    const std::size_t first = rod_deck.find("stiffness");
    const std::size_t last = rod_deck.find("[rod.r]");
    return std::string(rod_deck).replace(
        first, last - first, "shape = { " + shape + " }\nmaterial = { " + material + " }\n");
}

const std::string circle = "circle = { radius = 1 }";

std::vector<RoundTrip> shape_trips() {
    const auto area = [](double value) {
        return [=](const Problem& p) {
            return std::abs(p.model.sections[0].mass(0, 0) - value) < 1e-14 * value;
        };
    };
    const std::string steel = "E = 3, nu = 0.5, density = 1";
    return {
        {"section.NAME.shape.circle.radius", with_shape("circle = { radius = 2 }", steel), area(4 * M_PI)},
        {"section.NAME.shape.tube.outer_radius",
         with_shape("tube = { outer_radius = 3, inner_radius = 1 }", steel),
         area(8 * M_PI)},
        {"section.NAME.shape.tube.inner_radius",
         with_shape("tube = { outer_radius = 3, inner_radius = 2 }", steel),
         area(5 * M_PI)},
        {"section.NAME.shape.rectangle.width_y",
         with_shape("rectangle = { width_y = 2, height_z = 1 }", steel),
         [](const Problem& p) { return std::abs(p.model.sections[0].mass(5, 5) - 8.0 / 12.0) < 1e-15; }},
        {"section.NAME.shape.rectangle.height_z",
         with_shape("rectangle = { width_y = 1, height_z = 2 }", steel),
         [](const Problem& p) { return std::abs(p.model.sections[0].mass(4, 4) - 8.0 / 12.0) < 1e-15; }},
        {"section.NAME.material.E",
         with_shape(circle, "E = 7, nu = 0, density = 1"),
         [](const Problem& p) { return p.model.sections[0].stiffness(0, 0) == 7 * M_PI; }},
        {"section.NAME.material.nu",
         with_shape(circle, "E = 3, nu = 0.5, density = 1"),
         [](const Problem& p) { return p.model.sections[0].stiffness(3, 3) == M_PI / 2.0; }},
        {"section.NAME.material.G",
         with_shape(circle, "E = 3, G = 5, density = 1"),
         [](const Problem& p) { return p.model.sections[0].stiffness(3, 3) == 5.0 * M_PI / 2.0; }},
        {"section.NAME.material.density", with_shape(circle, "E = 3, nu = 0, density = 9"), area(9 * M_PI)},
        {"section.NAME.material.shear_factor",
         with_shape(circle, "E = 2, nu = 0, density = 1, shear_factor = 0.25"),
         [](const Problem& p) { return p.model.sections[0].stiffness(1, 1) == 0.25 * M_PI; }}};
}

std::vector<RoundTrip> matrix_trips() {
    const std::string identity =
        "[[2,0,0,0,0,0],[0,2,0,0,0,0],[0,0,2,0,0,0],[0,0,0,3,1,0],[0,0,0,1,4,0],[0,0,0,0,0,5]]";
    const auto has_entry = [](const Mat6& matrix) { return matrix(3, 4) == 1.0 && matrix(5, 5) == 5.0; };
    return {{"section.NAME.stiffness_matrix",
             replaced(rod_deck,
                      "stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }",
                      "stiffness_matrix = " + identity),
             [=](const Problem& p) { return has_entry(p.model.sections[0].stiffness); }},
            {"section.NAME.mass_matrix",
             replaced(rod_deck,
                      "inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }",
                      "mass_matrix = " + identity),
             [=](const Problem& p) { return has_entry(p.model.sections[0].mass); }},
            {"section.NAME.damping.kelvin_voigt",
             replaced(rod_deck, "[rod.r]", "damping = { kelvin_voigt = 0.125 }\n[rod.r]"),
             [](const Problem& p) { return p.model.sections[0].kelvin_voigt == 0.125; }},
            {"section.NAME.damping.mass_proportional",
             replaced(rod_deck, "[rod.r]", "damping = { mass_proportional = 0.125 }\n[rod.r]"),
             [](const Problem& p) { return p.model.sections[0].mass_proportional == 0.125; }}};
}

// rod_deck with another centreline.
std::string with_geometry(const std::string& geometry) {
    return replaced(rod_deck, "line = { from = [0, 0, 0], to = [10, 0, 0] }", geometry);
}

// Whether the node at a fraction of the rod's nodes is at a place.
std::function<bool(const Problem&)> passes(double fraction, const Vec3& place) {
    return [=](const Problem& p) {
        const Rod& rod = p.model.rods[0];
        const auto position = static_cast<std::size_t>(fraction * static_cast<double>(rod.nodes.size() - 1));
        return (p.model.nodes[static_cast<std::size_t>(rod.nodes[position])].position - place).norm() < 1e-13;
    };
}

std::vector<RoundTrip> geometry_trips() {
    const auto arc = [](const std::string& keys) { return with_geometry("arc = { " + keys + " }"); };
    const auto helix = [](const std::string& keys) { return with_geometry("helix = { " + keys + " }"); };
    const std::string mesh = "mesh = { file = \"" GXROD_SOURCE_DIR "/meshes/truss.geo\", group = ";
    const auto meshed = [&](const std::string& group) {
        return replaced(with_geometry(mesh + group + " }"), "elements = 10\n", "");
    };
    return {{"rod.NAME.arc.from",
             arc("from = [4, 0, 0], through = [5, 1, 0], to = [6, 0, 0]"),
             passes(0.0, {4, 0, 0})},
            {"rod.NAME.arc.through",
             arc("from = [4, 0, 0], through = [5, 1, 0], to = [6, 0, 0]"),
             passes(0.5, {5, 1, 0})},
            {"rod.NAME.arc.to",
             arc("from = [4, 0, 0], through = [5, 1, 0], to = [6, 0, 0]"),
             passes(1.0, {6, 0, 0})},
            {"rod.NAME.arc.centre",
             arc("from = [4, 0, 0], centre = [5, 0, 0], axis = [0, 0, 1], angle = \"pi\""),
             passes(1.0, {6, 0, 0})},
            {"rod.NAME.arc.axis",
             arc("from = [4, 0, 0], centre = [5, 0, 0], axis = [0, 2, 0], angle = \"pi\""),
             passes(0.5, {5, 0, 1})},
            {"rod.NAME.arc.angle",
             arc("from = [4, 0, 0], centre = [5, 0, 0], axis = [0, 0, 1], angle = \"pi/2\""),
             passes(1.0, {5, -1, 0})},
            {"rod.NAME.helix.centre",
             helix("centre = [1, 0, 9], axis = [0, 0, 1], from = [2, 0, 3], turns = 1.5, pitch = 2"),
             passes(1.0, {0, 0, 6})},
            {"rod.NAME.helix.axis",
             helix("centre = [0, 0, 0], axis = [0, 5, 0], from = [2, 0, 0], turns = 0.5, pitch = 2"),
             passes(1.0, {-2, 1, 0})},
            {"rod.NAME.helix.from",
             helix("centre = [0, 0, 0], axis = [0, 0, 1], from = [3, 0, 1], turns = 1, pitch = 2"),
             passes(0.0, {3, 0, 1})},
            {"rod.NAME.helix.turns",
             helix("centre = [0, 0, 0], axis = [0, 0, 1], from = [3, 0, 0], turns = 2.5, pitch = 2"),
             passes(1.0, {-3, 0, 5})},
            {"rod.NAME.helix.pitch",
             helix("centre = [0, 0, 0], axis = [0, 0, 1], from = [3, 0, 0], turns = 2, pitch = 7"),
             passes(1.0, {3, 0, 14})},
            {"rod.NAME.polyline",
             with_geometry("polyline = [[0, 0, 0], [2, 0, 0], [2, 2, 0]]"),
             passes(0.5, {2, 0, 0})},
            {"rod.NAME.spline",
             with_geometry("spline = [[0, 0, 1], [2, 1, 1], [4, 0, 1]]"),
             passes(0.5, {2, 1, 1})},
            {"rod.NAME.mesh.file",
             meshed("\"truss\""),
             [](const Problem& p) { return p.model.rods[0].element_count() == 12; }},
            {"rod.NAME.mesh.group", meshed("22"), [](const Problem& p) {
                 return p.model.rods[0].element_count() == 2;
             }}};
}

std::vector<RoundTrip> rod_trips() {
    return {{"rod.NAME.section",
             replaced(rod_deck, "section = \"s\"", "section = \"other\"") +
                 "[section.other]\nstiffness = { EA = 1, GAy = 1, GAz = 1, GJ = 1, EIy = 1, EIz = 1 }\n"
                 "inertia = { rhoA = 1, rhoIy = 1, rhoIz = 1 }\n",
             [](const Problem& p) { return p.model.sections[p.model.rods[0].section].name == "other"; }},
            {"rod.NAME.line.from",
             replaced(rod_deck, "from = [0, 0, 0]", "from = [1, 2, 3]"),
             [](const Problem& p) {
                 return p.model.nodes[p.model.rods[0].nodes.front()].position == Vec3(1, 2, 3);
             }},
            {"rod.NAME.line.to",
             replaced(rod_deck, "to = [10, 0, 0]", "to = [1, 2, 3]"),
             [](const Problem& p) {
                 return p.model.nodes[p.model.rods[0].nodes.back()].position == Vec3(1, 2, 3);
             }},
            {"rod.NAME.elements",
             replaced(rod_deck, "elements = 10", "elements = \"3 + 4\""),
             [](const Problem& p) { return p.model.rods[0].element_count() == 7; }},
            {"rod.NAME.spacing",
             with_rod_key("spacing = [[0, 1], [1, 3]]"),
             [](const Problem& p) {
                 const Rod& rod = p.model.rods[0];
                 // The last of n elements is 3^(1 - 1/n) as long as the first.
                 const double ratio =
                     (rod.length - rod.arc_length[rod.arc_length.size() - 2]) / rod.arc_length[1];
                 return std::abs(ratio - std::pow(3.0, 1.0 - 1.0 / rod.element_count())) < 1e-12;
             }},
            {"rod.NAME.order",
             with_rod_key("order = 3"),
             [](const Problem& p) { return p.model.rods[0].order == 3; }},
            {"rod.NAME.element",
             replaced(rod_deck, "\"simo\"", "\"objective\""),
             [](const Problem& p) { return p.model.rods[0].kind == ElementKind::objective; }},
            {"rod.NAME.sections",
             replaced(rod_deck, "section = \"s\"", "sections = [[0, \"s\"], [1, \"other\"]]") +
                 "[section.other]\nstiffness = { EA = 1, GAy = 1, GAz = 1, GJ = 1, EIy = 1, EIz = 1 }\n"
                 "inertia = { rhoA = 1, rhoIy = 1, rhoIz = 1 }\n",
             [](const Problem& p) {
                 const Rod& rod = p.model.rods[0];
                 return rod.has_varying_sections() && rod.varying.at_nodes.back().stiffness(0, 0) == 1.0;
             }},
            {"rod.NAME.twist",
             with_rod_key("twist = \"pi/2\""),
             [](const Problem& p) {
                 return (p.model.rods[0].triads.back() * Vec3::UnitY()).isApprox(Vec3::UnitZ(), 1e-15);
             }},
            {"rod.NAME.y_axis",
             replaced(rod_deck, "element = \"simo\"", "element = \"simo\"\ny_axis = [5, 0, -2]"),
             [](const Problem& p) {
                 return (p.model.rods[0].triads[0] * Vec3::UnitY()).isApprox(Vec3(0, 0, -1), 1e-15);
             }}};
}

std::vector<RoundTrip> body_trips() {
    const auto node = [](const Problem& p) { return p.model.nodes[p.model.bodies[0].node]; };
    return {{"body.NAME.mass",
             replaced(body_deck, "mass = 1.0", "mass = 2.5"),
             [](const Problem& p) { return p.model.bodies[0].mass == 2.5; }},
            {"body.NAME.inertia",
             replaced(body_deck, "[1, 1, 1]", "[2, 3, 4]"),
             [](const Problem& p) { return p.model.bodies[0].inertia == Mat3(Vec3(2, 3, 4).asDiagonal()); }},
            {"body.NAME.at",
             with_body_key("at = [1, 2, 3]"),
             [=](const Problem& p) { return node(p).position == Vec3(1, 2, 3); }},
            {"body.NAME.centre_of_mass",
             with_body_key("centre_of_mass = [1, 2, 3]"),
             [](const Problem& p) { return p.model.bodies[0].centre_of_mass == Vec3(1, 2, 3); }},
            {"body.NAME.rotation_vector",
             with_body_key("rotation_vector = [0, 0, \"pi/2\"]"),
             [](const Problem& p) {
                 return (p.model.bodies[0].attitude * Vec3::UnitX()).isApprox(Vec3::UnitY(), 1e-15);
             }},
            {"body.NAME.velocity",
             with_body_key("velocity = [1, 2, 3]"),
             [=](const Problem& p) { return node(p).velocity == Vec3(1, 2, 3); }},
            {"body.NAME.angular_velocity",
             with_body_key("rotation_vector = [0, 0, \"pi/2\"]\nangular_velocity = [1, 2, 3]"),
             [=](const Problem& p) { return node(p).angular_velocity == Vec3(1, 2, 3); }},
            {"body.NAME.angular_velocity_material",
             with_body_key("rotation_vector = [0, 0, \"pi/2\"]\nangular_velocity_material = [1, 2, 3]"),
             [=](const Problem& p) { return node(p).angular_velocity.isApprox(Vec3(-2, 1, 3), 1e-15); }}};
}

// Two stages, whose first is the deck's analysis.
std::string staged(std::string deck) {
    deck = replaced(deck, "[analysis]", "[[stage]]\nname = \"one\"");
    return deck + "\n[[stage]]\nname = \"two\"\nkind = \"static\"\n";
}

ResponseSettings response_of(const Problem& p) {
    const auto* response = std::get_if<ResponseSettings>(&p.analysis);
    return response != nullptr ? *response : ResponseSettings{};
}

std::vector<RoundTrip> response_trips() {
    const auto with = [](const std::string& keys) {
        return replaced(static_rod_deck, "\"static\"", "\"response\"") + keys;
    };
    const std::string excited =
        "excite = [{ at = \"r.end\", force = [1, 2, 3], moment = [4, 5, 6], phase = 0.5 }]\n"
        "[[history]]\nname = \"tip\"\nat = \"r.end\"\nquantities = [\"displacement\"]\n";
    const auto excites = [](const auto& test) {
        return [test](const Problem& p) {
            const std::vector<Excitation> found = response_of(p).excitation;
            return found.size() == 1 && test(found[0]);
        };
    };
    std::vector<RoundTrip> trips{{"analysis.excite.at",
                                  with("omega = { values = [1] }\n" + excited),
                                  excites([](const Excitation& one) { return one.node == 10; })},
                                 {"analysis.excite.force",
                                  with("omega = { values = [1] }\n" + excited),
                                  excites([](const Excitation& one) { return one.force == Vec3(1, 2, 3); })},
                                 {"analysis.excite.moment",
                                  with("omega = { values = [1] }\n" + excited),
                                  excites([](const Excitation& one) { return one.moment == Vec3(4, 5, 6); })},
                                 {"analysis.excite.phase",
                                  with("omega = { values = [1] }\n" + excited),
                                  excites([](const Excitation& one) { return one.phase == 0.5; })}};
    for (const std::string name : {"omega", "frequency"}) {
        const double unit = name == "omega" ? 1.0 : 2.0 * M_PI;
        const auto sweeps = [&](const std::string& keys, std::vector<double> expected) {
            for (double& value : expected) value *= unit;
            return std::pair{with(name + " = { " + keys + " }\n" + excited), [expected](const Problem& p) {
                                 const std::vector<double> found = response_of(p).omegas;
                                 bool is_same = found.size() == expected.size();
                                 for (std::size_t i = 0; is_same && i < found.size(); ++i)
                                     is_same = std::abs(found[i] - expected[i]) < 1e-12 * expected[i];
                                 return is_same;
                             }};
        };
        const auto linear = sweeps("from = 1, to = 3, count = 3", {1, 2, 3});
        const auto ratios = sweeps("from = 1, to = 4, count = 3, spacing = \"log\"", {1, 2, 4});
        const auto listed = sweeps("values = [2, 5]", {2, 5});
        for (const char* key : {"from", "to", "count"})
            trips.push_back({"analysis." + name + "." + key, linear.first, linear.second});
        trips.push_back({"analysis." + name + ".spacing", ratios.first, ratios.second});
        trips.push_back({"analysis." + name + ".values", listed.first, listed.second});
    }
    return trips;
}

std::vector<RoundTrip> sweep_trips() {
    const auto with = [](const std::string& keys) {
        return replaced(static_rod_deck, "\"static\"", "\"eigenvalues\"") +
               "sweep = { key = \"section.s.stiffness.EA\", " + keys + " }\n";
    };
    const auto sweeps = [](const auto& test) {
        return [test](const Problem& p) {
            const auto* settings = std::get_if<EigenvalueSettings>(&p.stages[0].analysis);
            return settings != nullptr && settings->sweep && test(*settings->sweep);
        };
    };
    const auto has = [&](std::vector<double> expected) {
        return sweeps([expected](const EigenvalueSweep& sweep) {
            bool is_same = sweep.values.size() == expected.size();
            for (std::size_t i = 0; is_same && i < expected.size(); ++i)
                is_same = std::abs(sweep.values[i] - expected[i]) < 1e-12 * expected[i];
            return is_same;
        });
    };
    return {
        {"analysis.sweep.key", with("values = [1]"), sweeps([](const EigenvalueSweep& sweep) {
             return sweep.key == "section.s.stiffness.EA";
         })},
        {"analysis.sweep.from", with("from = 3, to = 1, count = 3"), has({3, 2, 1})},
        {"analysis.sweep.to", with("from = 1, to = 21"), has({1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11,
                                                              12, 13, 14, 15, 16, 17, 18, 19, 20, 21})},
        {"analysis.sweep.count", with("from = 1, to = 3, count = 2"), has({1, 3})},
        {"analysis.sweep.spacing", with("from = 1, to = 4, count = 3, spacing = \"log\""), has({1, 2, 4})},
        {"analysis.sweep.values", with("values = [5, 2]"), has({5, 2})},
        {"analysis.sweep.onset",
         with("values = [1], onset = \"off\""),
         sweeps([](const EigenvalueSweep& sweep) { return !sweep.finds_onset; })}};
}

std::vector<RoundTrip> rotation_trips() {
    const std::string deck = replaced(static_rod_deck, "\"static\"", "\"steady\"") + "[rotation]\n";
    const auto is_about_x = [](const Problem& p) {
        return p.model.rotation && p.model.rotation->axis == Vec3::UnitX();
    };
    return {{"rotation.axis", deck + "speed = 2\naxis = [3, 0, 0]\n", is_about_x},
            {"rotation.through",
             deck + "speed = 2\nthrough = [1, 2, 3]\n",
             [](const Problem& p) { return p.model.rotation->through == Vec3(1, 2, 3); }},
            {"rotation.speed", deck + "speed = 2\n", [](const Problem& p) {
                 return p.model.rotation->speed(0.5) == 1.0 && p.model.rotation->speed(1.0) == 2.0;
             }}};
}

// Keys by which loads and supports know of stages, and the plane of all.
std::vector<RoundTrip> action_trips() {
    const std::string deck = staged(rod_deck);
    return {{"load.factor",
             rod_deck + force + "factor = \"3*t\"\n",
             [](const Problem& p) { return p.model.loads[0].force[2](2.0) == 18.0; }},
            {"load.stages",
             deck + force + "stages = [\"two\"]\n",
             [](const Problem& p) {
                 return p.model.loads.empty() && p.stages[1].actions.loads[0].force[0](4.0) == 8.0;
             }},
            {"support.stages",
             deck + "[[support]]\nat = \"r.end\"\nfix = \"x\"\nstages = \"two\"\n",
             [](const Problem& p) {
                 return p.model.supports.empty() && p.stages[1].actions.supports.size() == 1;
             }},
            {"plane", "plane = \"xy\"\n" + rod_deck, [](const Problem& p) {
                 return p.model.plane && p.model.plane->normal == 2;
             }}};
}

std::vector<RoundTrip> load_trips() {
    const std::string along = rod_deck + "[[load]]\non = \"r\"\nforce_per_length = [\"2*t + s\", 0, 3]\n";
    const auto is_seen = [](const std::array<LineFunction, 3>& value) {
        return value[0](4.0, 0.5) == 8.5 && value[2](0.0, 1.0) == 3.0;
    };
    return {
        {"load.at", rod_deck + force, [](const Problem& p) { return p.model.loads[0].node == 10; }},
        {"load.force",
         rod_deck + force,
         [](const Problem& p) {
             return p.model.loads[0].force[0](4.0) == 8.0 && p.model.loads[0].force[2](0.0) == 3.0;
         }},
        {"load.moment",
         rod_deck + replaced(force, "force", "moment"),
         [](const Problem& p) {
             return p.model.loads[0].moment[0](4.0) == 8.0 && p.model.loads[0].moment[2](0.0) == 3.0;
         }},
        {"load.on",
         along,
         [](const Problem& p) { return p.model.loads.empty() && p.model.distributed_loads.at(0).rod == 0; }},
        {"load.force_per_length",
         along,
         [=](const Problem& p) { return is_seen(p.model.distributed_loads[0].force); }},
        {"load.moment_per_length",
         replaced(along, "force_per", "moment_per"),
         [=](const Problem& p) { return is_seen(p.model.distributed_loads[0].moment); }},
        {"load.frame", rod_deck + force + "frame = \"follower\"", [](const Problem& p) {
             return p.model.loads[0].frame == Frame::follower;
         }}};
}

std::vector<RoundTrip> support_trips() {
    std::vector<RoundTrip> trips{
        {"support.at",
         rod_deck + "[[support]]\nat = \"r.start\"\nfix = \"x\"\n",
         [](const Problem& p) { return p.model.supports[0].node == 0; }},
        {"support.fix",
         rod_deck + "[[support]]\nat = \"r.end\"\nfix = [\"y\", \"rx\", \"rz\"]\n",
         [](const Problem& p) {
             return p.model.supports[0].fixed == std::array{false, true, false, true, false, true};
         }},
        {"support.axes",
         rod_deck + "[[support]]\nat = \"r.end\"\nfix = \"x\"\naxes = [[0, 1, 0], [0, 0, 1], [1, 0, 0]]\n",
         [](const Problem& p) {
             return (p.model.supports[0].axes * Vec3::UnitX()).isApprox(Vec3::UnitY(), 1e-15);
         }}};
    for (std::size_t i = 0; i < component_names.size(); ++i) {
        const std::string name(component_names[i]);
        // A rotation that moves needs the other two.
        std::string others;
        for (std::size_t k = i < 3 ? 0 : 3; k < (i < 3 ? 3 : 6); ++k) {
            if (k != i) others += (others.empty() ? "\"" : ", \"") + std::string(component_names[k]) + "\"";
        }
        trips.push_back({"support.move." + name,
                         rod_deck + "[[support]]\nat = \"r.end\"\nfix = [" + others + "]\nmove = { " + name +
                             " = \"3*t\" }\n",
                         [i](const Problem& p) {
                             const Support& support = p.model.supports[0];
                             return support.moved[i] && support.motion[i](2.0) == 6.0;
                         }});
    }
    return trips;
}

std::vector<RoundTrip> connection_and_initial_trips() {
    const std::string initial = "[[initial]]\non = \"r\"\nvelocity = [\"x\", \"2*s\", 1]\n";
    return {
        {"connect.points",
         rod_deck + "[rod.q]\nsection = \"s\"\nline = { from = [10, 0, 0], to = [10, 5, 0] }\nelements = 2\n"
                    "element = \"simo\"\n[[connect]]\npoints = [\"r.end\", \"q.start\"]\n",
         [](const Problem& p) { return p.model.rods[1].nodes[0] == 10; }},
        {"initial.on",
         rod_deck + initial,
         [](const Problem& p) { return p.model.nodes[10].velocity != Vec3::Zero(); }},
        {"initial.velocity",
         rod_deck + initial,
         [](const Problem& p) { return p.model.nodes[3].velocity == Vec3(3, 6, 1); }},
        {"initial.angular_velocity",
         rod_deck + replaced(initial, "velocity", "angular_velocity"),
         [](const Problem& p) { return p.model.nodes[3].angular_velocity == Vec3(3, 6, 1); }}};
}

std::string shape_deck(const std::string& kind, const std::string& key) {
    const std::string deck = replaced(body_deck, "\"dynamic\"", "\"" + kind + "\"");
    return replaced(replaced(deck, "end_time = 1.0\n", ""), "steps = 10", key);
}

std::vector<RoundTrip> analysis_trips() {
    return {
        {"analysis.kind",
         static_rod_deck,
         [](const Problem& p) { return std::holds_alternative<StaticSettings>(p.analysis); }},
        {"analysis.end_time",
         replaced(body_deck, "end_time = 1.0", "end_time = 2.5"),
         [](const Problem& p) { return dynamic_of(p).end_time == 2.5; }},
        {"analysis.time_step",
         replaced(body_deck, "steps = 10", "time_step = 0.125"),
         [](const Problem& p) { return dynamic_of(p).steps == 8; }},
        {"analysis.steps",
         replaced(body_deck, "steps = 10", "steps = 123"),
         [](const Problem& p) { return dynamic_of(p).steps == 123; }},
        {"analysis.accuracy",
         replaced(body_deck, "steps = 10", "accuracy = 0.02"),
         [](const Problem& p) { return adaptive_of(p).tolerance == 0.01 * 0.02; }},
        {"analysis.integrator",
         body_deck + "integrator = \"sdirk-4\"",
         [](const Problem& p) { return dynamic_of(p).scheme == Scheme::sdirk_4; }},
        {"analysis.beta",
         body_deck + "beta = 0.3",
         [](const Problem& p) { return dynamic_of(p).beta == 0.3; }},
        {"analysis.gamma",
         body_deck + "gamma = 0.6",
         [](const Problem& p) { return dynamic_of(p).gamma == 0.6; }},
        {"analysis.spectral_radius",
         body_deck + "integrator = \"generalized-alpha\"\nspectral_radius = 0.3",
         [](const Problem& p) { return dynamic_of(p).spectral_radius == 0.3; }},
        {"analysis.start",
         body_deck + "start = \"project\"",
         [](const Problem& p) { return dynamic_of(p).projects_start; }},
        {"analysis.adaptive.tolerance",
         body_deck + "integrator = \"sdirk-4\"\nadaptive = { tolerance = 1e-5 }",
         [](const Problem& p) { return adaptive_of(p).tolerance == 1e-5; }},
        {"analysis.adaptive.min_step",
         body_deck + "integrator = \"sdirk-4\"\nadaptive = { min_step = 1e-5 }",
         [](const Problem& p) { return adaptive_of(p).min_step == 1e-5; }},
        {"analysis.adaptive.max_step",
         body_deck + "integrator = \"sdirk-4\"\nadaptive = { max_step = 0.2 }",
         [](const Problem& p) { return adaptive_of(p).max_step == 0.2; }},
        {"analysis.newton.tolerance",
         body_deck + "newton = { tolerance = 1e-5 }",
         [](const Problem& p) { return dynamic_of(p).newton.tolerance == 1e-5; }},
        {"analysis.newton.max_iterations",
         body_deck + "newton = { max_iterations = 7 }",
         [](const Problem& p) { return dynamic_of(p).newton.max_iterations == 7; }},
        {"analysis.newton.tangent",
         body_deck + "newton = { tangent = \"paper\" }",
         [](const Problem& p) { return dynamic_of(p).newton.tangent == TangentKind::paper; }},
        {"analysis.count",
         shape_deck("buckling", "count = 7"),
         [](const Problem& p) { return std::get<BucklingSettings>(p.analysis).count == 7; }},
        {"analysis.below",
         shape_deck("modes", "below = 7"),
         [](const Problem& p) { return std::get<ModesSettings>(p.analysis).below == 7.0; }},
        {"analysis.linear_solver",
         body_deck + "linear_solver = \"klu\"",
         [](const Problem& p) { return dynamic_of(p).linear_solver == LinearSolverKind::klu; }},
        {"output.every",
         body_deck + "[output]\nevery = 5",
         [](const Problem& p) { return p.output.every == 5; }},
        {"output.interval",
         body_deck + "[output]\ninterval = 0.05",
         [](const Problem& p) { return p.output.interval == 0.05; }},
        {"output.times",
         body_deck + "[output]\ntimes = [0.25, \"1/3\"]",
         [](const Problem& p) {
             return p.output.times == std::vector{0.25, 1.0 / 3.0};
         }},
        {"output.history_interval",
         body_deck + "[output]\nhistory_interval = 0.05",
         [](const Problem& p) { return p.output.history_interval == 0.05; }},
        {"output.compression",
         body_deck + "[output]\ncompression = \"deflate\"",
         [](const Problem& p) { return p.output.compression == Compression::deflate; }},
        {"history.name",
         with_history("name = \"tip-1\""),
         [](const Problem& p) { return p.output.histories[0].name == "tip-1"; }},
        {"history.at",
         with_history("at = \"r@0.3\""),
         [](const Problem& p) {
             return p.output.histories[0].at == "r@0.3" && p.output.histories[0].node == 3;
         }},
        {"history.relative_to",
         with_history("relative_to = \"r.start\""),
         [](const Problem& p) {
             return p.output.histories[0].relative_to == "r.start" &&
                    p.output.histories[0].relative_node == 0;
         }},
        {"history.quantities", with_history("quantities = [\"strain\", \"velocity\"]"), [](const Problem& p) {
             return p.output.histories[0].quantities == std::vector{Quantity::strain, Quantity::velocity};
         }}};
}

std::vector<RoundTrip> path_trips() {
    const auto with = [](const std::string& until, const std::string& more = "") {
        return replaced(static_rod_deck, "\"static\"", "\"path\"\nuntil = { " + until + " }\n" + more);
    };
    const auto is_target = [](const Problem& p, int node, int component, const std::vector<double>& values) {
        const std::vector<PathTarget> targets = path_of(p).at;
        return targets.size() == 1 && targets[0].node == node && targets[0].component == component &&
               targets[0].values == values;
    };
    const std::string at = "at = [{ of = \"r.end\", displacement = \"y\", values = [\"1/2\", 3] }]";
    const auto is_control = [](int node, int component, std::optional<double> to) {
        return [=](const Problem& p) {
            const std::optional<PathControl> control = path_of(p).control;
            return control && control->node == node && control->component == component && control->to == to;
        };
    };
    const std::string control = "control = { of = \"r.end\", displacement = \"y\", to = -3 }";
    const std::string turned = "control = { of = \"r.end\", rotation = \"z\" }";
    return {
        {"analysis.control.of", with("t = 1", control), is_control(10, 1, -3.0)},
        {"analysis.control.displacement", with("t = 1", control), is_control(10, 1, -3.0)},
        {"analysis.control.to", with("t = 1", control), is_control(10, 1, -3.0)},
        {"analysis.control.rotation", with("t = 1", turned), is_control(10, 5, std::nullopt)},
        {"analysis.until.t",
         with("t = [-1, 2]"),
         [](const Problem& p) { return path_of(p).least_load == -1.0 && path_of(p).greatest_load == 2.0; }},
        {"analysis.until.arc",
         with("arc = 2.5"),
         [](const Problem& p) { return path_of(p).arc == 2.5 && !path_of(p).steps; }},
        {"analysis.until.steps",
         with("steps = 25"),
         [](const Problem& p) { return path_of(p).steps == 25 && !path_of(p).points; }},
        {"analysis.until.points",
         with("points = 3"),
         [](const Problem& p) { return path_of(p).points == 3 && !path_of(p).greatest_load; }},
        {"analysis.step",
         with("t = 1", "step = 0.01"),
         [](const Problem& p) { return path_of(p).first_step == 0.01; }},
        {"analysis.max_step",
         with("t = 1", "max_step = 0.07"),
         [](const Problem& p) { return path_of(p).max_step == 0.07; }},
        {"analysis.min_step",
         with("t = 1", "min_step = 1e-4"),
         [](const Problem& p) { return path_of(p).min_step == 1e-4; }},
        {"analysis.at.of",
         with("t = 1", at),
         [=](const Problem& p) {
             return is_target(p, 10, 1, {0.5, 3.0});
         }},
        {"analysis.at.displacement",
         with("t = 1", replaced(at, "\"y\"", "\"z\"")),
         [=](const Problem& p) {
             return is_target(p, 10, 2, {0.5, 3.0});
         }},
        {"analysis.at.values",
         with("t = 1", replaced(at, "[\"1/2\", 3]", "[7]")),
         [=](const Problem& p) { return is_target(p, 10, 1, {7.0}); }},
        {"analysis.at.t",
         with("t = 1", "at = [{ t = [0.25] }]"),
         [=](const Problem& p) { return is_target(p, -1, 0, {0.25}); }},
        {"analysis.critical",
         with("t = 1", "critical = \"report\""),
         [](const Problem& p) { return path_of(p).critical == CriticalSearch::report; }},
        {"analysis.branches", with("t = 1", "branches = 2"), [](const Problem& p) {
             return path_of(p).branches == 2;
         }}};
}

// The keys of a stage are those of [analysis].
std::vector<RoundTrip> stage_trips() {
    std::vector<RoundTrip> trips;
    std::vector<RoundTrip> of_analysis = analysis_trips();
    for (RoundTrip& trip : path_trips()) of_analysis.push_back(std::move(trip));
    for (RoundTrip& trip : response_trips()) of_analysis.push_back(std::move(trip));
    for (RoundTrip& trip : sweep_trips()) of_analysis.push_back(std::move(trip));
    for (RoundTrip& trip : of_analysis) {
        if (!trip.key.starts_with("analysis.")) continue;
        trip.key = replaced(trip.key, "analysis", "stage");
        trip.deck = staged(trip.deck);
        trips.push_back(trip);
    }
    trips.push_back({"stage.name", staged(static_rod_deck), [](const Problem& p) {
                         return p.stages.size() == 2 && p.stages[0].name == "one";
                     }});
    return trips;
}

// A limit point that is followed takes a path before.
std::vector<RoundTrip> follow_trips() {
    const std::string path = "kind = \"path\"\nuntil = { t = 1, points = 1 }\n";
    const std::string deck = replaced(static_rod_deck, "[analysis]\nkind = \"static\"\n", "") +
                             "[[stage]]\nname = \"one\"\n" + path + "[[stage]]\nname = \"two\"\n" + path +
                             "follow = \"limit\"\n[[load]]\nat = \"r.end\"\nforce = [1, 0, 0]\n"
                             "relative_to = \"limit\"\n";
    const auto follows = [](const Problem& p) { return p.stages.size() == 2 && follows_limits(p.stages); };
    return {{"analysis.follow", deck, follows},
            {"stage.follow", deck, follows},
            {"load.relative_to", deck, follows}};
}

std::vector<RoundTrip> all_trips() {
    std::vector<RoundTrip> all;
    for (const auto& trips : {top_level_trips(),     section_trips(),
                              shape_trips(),         matrix_trips(),
                              law_trips(),           drive_trips(),
                              geometry_trips(),      rod_trips(),
                              section_file_trips(),  section_frame_trips(),
                              spin_trips(),          rest_trips(),
                              history_frame_trips(), body_trips(),
                              spring_trips(),        bushing_trips(),
                              joint_trips(),         gear_trips(),
                              coordinate_trips(),    load_trips(),
                              action_trips(),        rotation_trips(),
                              response_trips(),      sweep_trips(),
                              support_trips(),       connection_and_initial_trips(),
                              analysis_trips(),      path_trips(),
                              follow_trips(),        stage_trips(),
                              surroundings_trips(),  contact_trips()}) {
        all.insert(all.end(), trips.begin(), trips.end());
    }
    return all;
}

void add_leaf_paths(const TableSpec& table, const std::string& prefix, std::set<std::string>& paths) {
    for (const KeySpec& key : table.keys) {
        const std::string path = prefix + key.name;
        switch (key.type) {
            case ValueType::table:
            case ValueType::table_list:
                add_leaf_paths(*key.table, path + ".", paths);
                break;
            case ValueType::named_tables:
                add_leaf_paths(*key.table, path + ".NAME.", paths);
                break;
            case ValueType::stations:
            case ValueType::number_or_table:
                add_leaf_paths(*key.table, path + ".", paths);
                [[fallthrough]];
            default:
                paths.insert(path);
        }
    }
}

}  // namespace

TEST_CASE("Every key of a deck is seen in the problem", "[deck]") {
    for (const RoundTrip& trip : all_trips()) {
        INFO(trip.key << "\n" << trip.deck);
        CHECK(trip.is_seen(read(trip.deck)));
    }
}

TEST_CASE("The values that round trips see are not there by default", "[deck]") {
    // These have one valid value only.
    const std::set<std::string> single{"analysis.kind", "stage.kind", "stage.name"};
    for (const RoundTrip& trip : all_trips()) {
        if (single.contains(trip.key)) continue;
        const bool has_loads = trip.key.starts_with("load") || trip.key.starts_with("function");
        const bool has_others = trip.key.starts_with("support") || trip.key.starts_with("history") ||
                                trip.key.starts_with("connect") || trip.key.starts_with("spring") ||
                                trip.key.starts_with("bushing") || trip.key.starts_with("joint") ||
                                trip.key.starts_with("initial") || trip.key.starts_with("gear") ||
                                trip.key.starts_with("rotation") || trip.key.starts_with("tendon") ||
                                trip.key.starts_with("actuation") || trip.key.starts_with("magnetic");
        if (has_loads || has_others) continue;  // not there at all without their table
        const bool of_rod = trip.key.starts_with("rod") || trip.key.starts_with("section");
        INFO(trip.key);
        const bool of_shapes = (trip.key.ends_with(".count") && !trip.key.ends_with("sweep.count")) ||
                               trip.key.ends_with(".below");
        const std::string kind = trip.key.ends_with(".count") ? "buckling" : "modes";
        const std::string bare = of_shapes ? shape_deck(kind, "") : of_rod ? rod_deck : body_deck;
        CHECK_FALSE(trip.is_seen(read(bare)));
    }
}

TEST_CASE("Every key of the schema has a round trip", "[deck]") {
    std::set<std::string> in_schema;
    add_leaf_paths(deck_schema(), "", in_schema);
    std::set<std::string> tried;
    for (const RoundTrip& trip : all_trips()) tried.insert(trip.key);
    CHECK(tried == in_schema);
}

}  // namespace gxrod::test
