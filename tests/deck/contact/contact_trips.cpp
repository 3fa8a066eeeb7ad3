#include "deck/decks.hpp"
#include "deck/round_trips.hpp"

namespace gxrod::test {
namespace {

// Two wires, far from what is added.
std::string wires(const std::string& more, const std::string& section = "") {
    return "[section.s]\nshape = { circle = { radius = 0.01 } }\n"
           "material = { E = 1e9, nu = 0.3, density = 1000 }\n" +
           section +
           "[rod.a]\nsection = \"s\"\nline = { from = [0, 0, 0], to = [1, 0, 0] }\nelements = 4\n"
           "[rod.b]\nsection = \"s\"\nline = { from = [0, 1, 0], to = [1, 1, 0] }\nelements = 4\n" +
           more + "[analysis]\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\n";
}

// The first, or one of nothing.
Obstacle obstacle(const Problem& problem) {
    if (!problem.model.contact.obstacles.empty()) return problem.model.contact.obstacles[0];
    Obstacle none;
    none.line = {Vec3::Zero(), Vec3::Zero()};
    return none;
}

std::string with_obstacle(const std::string& keys) { return wires("[obstacle.o]\n" + keys + "\n"); }
const std::string floor_keys = "plane = { point = [1, 2, -3], normal = [0, 0, 2] }\n";

RoundTrip shape_trip(const std::string& key,
                     const std::string& value,
                     std::function<bool(const Obstacle&)> is_seen) {
    return {"obstacle.NAME." + key, with_obstacle(value), [is_seen](const Problem& problem) {
                return is_seen(obstacle(problem));
            }};
}

RoundTrip move_trip(const std::string& component, std::function<double(const ObstacleMotion&)> find) {
    return {"obstacle.NAME.move." + component,
            with_obstacle(floor_keys + "move = { " + component + " = \"3*t\" }"),
            [find](const Problem& problem) {
                const Obstacle one = obstacle(problem);
                return one.motion && find(*one.motion) == 1.5;
            }};
}

}  // namespace

std::vector<RoundTrip> contact_trips() {
    const std::string sphere = "sphere = { centre = [0, 0, -3], radius = 0.5, side = \"outside\" }";
    const std::string hollow = "sphere = { centre = [0, 0, 0], radius = 50, side = \"inside\" }";
    const std::string cylinder = "cylinder = { from = [0, 0, -3], to = [1, 0, -3], radius = 0.5 }";
    const std::string pipe =
        "cylinder = { from = [0, 0, 0], to = [1, 0, 0], radius = 50, side = \"inside\" }";
    const std::string arc =
        "tube = { arc = { from = [5, 0, -9], through = [0, 5, -9], to = [-5, 0, -9] }, radius = 0.5 }";
    const auto has_shape = [](Obstacle::Shape shape) {
        return [shape](const Obstacle& one) { return one.shape == shape; };
    };
    using Shape = Obstacle::Shape;
    return {
        {"contact.rods",
         wires("[contact]\nrods = \"b\"\n"),
         [](const Problem& p) {
             return p.model.contact.radii == std::vector{0.0, 0.01};
         }},
        {"contact.each_other",
         wires("[contact]\neach_other = false\n"),
         [](const Problem& p) { return !p.model.contact.between_rods && p.model.contact.within_rods; }},
        {"contact.self",
         wires("[contact]\nself = false\n"),
         [](const Problem& p) { return p.model.contact.between_rods && !p.model.contact.within_rods; }},
        {"contact.bend_radius",
         wires("[contact]\nbend_radius = 0.7\n"),
         [](const Problem& p) {
             return p.model.contact.bend_radii == std::vector{0.7, 0.7};
         }},
        {"contact.friction",
         wires("[contact]\nfriction = 0.4\n[obstacle.o]\n" + floor_keys),
         [](const Problem& p) { return obstacle(p).friction == 0.4; }},
        {"contact.skin",
         wires("[contact]\nskin = 0.05\n"),
         [](const Problem& p) { return p.model.contact.skin == 0.05; }},
        {"contact.dissipation",
         wires("[contact]\ndissipation = 0.25\n"),
         [](const Problem& p) { return p.model.contact.dissipation == 0.25; }},
        {"section.NAME.radius",
         wires("[contact]\n", "radius = 0.03\n"),
         [](const Problem& p) {
             return p.model.contact.radii == std::vector{0.03, 0.03};
         }},
        shape_trip("plane", floor_keys, has_shape(Shape::plane)),
        shape_trip(
            "plane.point", floor_keys, [](const Obstacle& one) { return one.line[0] == Vec3(1, 2, -3); }),
        shape_trip(
            "plane.normal", floor_keys, [](const Obstacle& one) { return one.normal == Vec3(0, 0, 1); }),
        shape_trip("sphere", sphere, has_shape(Shape::sphere)),
        shape_trip(
            "sphere.centre", sphere, [](const Obstacle& one) { return one.line[0] == Vec3(0, 0, -3); }),
        shape_trip("sphere.radius", sphere, [](const Obstacle& one) { return one.radius == 0.5; }),
        shape_trip("sphere.side", hollow, [](const Obstacle& one) { return one.is_hollow; }),
        shape_trip("cylinder", cylinder, has_shape(Shape::cylinder)),
        shape_trip(
            "cylinder.from", cylinder, [](const Obstacle& one) { return one.line[0] == Vec3(0, 0, -3); }),
        shape_trip(
            "cylinder.to", cylinder, [](const Obstacle& one) { return one.line[1] == Vec3(1, 0, -3); }),
        shape_trip("cylinder.radius", cylinder, [](const Obstacle& one) { return one.radius == 0.5; }),
        shape_trip("cylinder.side", pipe, [](const Obstacle& one) { return one.is_hollow; }),
        shape_trip("tube", arc, has_shape(Shape::tube)),
        shape_trip("tube.arc",
                   arc,
                   [](const Obstacle& one) { return (one.line.back() - Vec3(-5, 0, -9)).norm() < 1e-12; }),
        shape_trip("tube.helix",
                   "tube = { helix = { centre = [0, 0, -9], axis = [0, 0, -1], from = [2, 0, -9], turns = 2, "
                   "pitch = 3 }, "
                   "radius = 0.5 }",
                   [](const Obstacle& one) { return (one.line.back() - Vec3(2, 0, -15)).norm() < 1e-12; }),
        shape_trip("tube.spline",
                   "tube = { spline = [[0, 0, -9], [1, 1, -9], [2, 0, -9]], radius = 0.5 }",
                   [](const Obstacle& one) { return (one.line.back() - Vec3(2, 0, -9)).norm() < 1e-12; }),
        shape_trip("tube.radius", arc, [](const Obstacle& one) { return one.radius == 0.5; }),
        shape_trip("tube.side",
                   "tube = { spline = [[-9, 0, 0], [0, 0, 0], [9, 0, 0]], radius = 5, side = \"inside\" }",
                   [](const Obstacle& one) { return one.is_hollow; }),
        shape_trip("friction",
                   floor_keys + "friction = 0.7",
                   [](const Obstacle& one) { return one.friction == 0.7; }),
        shape_trip("stiffness",
                   floor_keys + "stiffness = 30",
                   [](const Obstacle& one) { return one.stiffness == 30.0; }),
        shape_trip("move",
                   floor_keys + "move = { x = \"t\" }",
                   [](const Obstacle& one) { return one.motion.has_value(); }),
        move_trip("x", [](const ObstacleMotion& motion) { return motion.displacement(0.5).x(); }),
        move_trip("y", [](const ObstacleMotion& motion) { return motion.displacement(0.5).y(); }),
        move_trip("z", [](const ObstacleMotion& motion) { return motion.displacement(0.5).z(); }),
        move_trip("rx", [](const ObstacleMotion& motion) { return motion.rotation(0.5).x(); }),
        move_trip("ry", [](const ObstacleMotion& motion) { return motion.rotation(0.5).y(); }),
        move_trip("rz", [](const ObstacleMotion& motion) { return motion.rotation(0.5).z(); }),
        shape_trip("move.about",
                   floor_keys + "move = { rx = \"t\", about = [4, 5, 6] }",
                   [](const Obstacle& one) { return one.motion && one.motion->about == Vec3(4, 5, 6); }),
    };
}

}  // namespace gxrod::test
