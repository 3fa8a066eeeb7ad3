#include <cmath>
#include <memory>
#include <variant>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"

namespace gxrod::test {
namespace {

// Two wires, far from what is added.
std::string wires(const std::string& more, const std::string& section = "") {
    const auto rod = [](const char* name, int y) {
        return std::string("[rod.") + name + "]\nsection = \"s\"\nelements = 4\nline = { from = [0, " +
               std::to_string(y) + ", 0], to = [1, " + std::to_string(y) + ", 0] }\n";
    };
    return "[section.s]\nshape = { circle = { radius = 0.01 } }\n"
           "material = { E = 1e9, nu = 0.3, density = 1000 }\n" +
           section + rod("a", 0) + rod("b", 1) + more +
           "[analysis]\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\n";
}

// The only one, or one that no trip sees.
ContactException exception(const Problem& problem) {
    if (!problem.model.contact.exceptions.empty()) return problem.model.contact.exceptions.at(0);
    return {};
}

// The first, or one that no trip sees.
Obstacle obstacle(const Problem& problem) {
    if (!problem.model.contact.obstacles.empty()) return problem.model.contact.obstacles[0];
    return {};
}

const std::string floor_keys = "plane = { point = [1, 2, -3], normal = [0, 0, 2] }\n";

RoundTrip trip(const std::string& key,
               const std::string& keys,
               const std::function<bool(const Obstacle&)>& is_seen) {
    return {"obstacle.NAME." + key, wires("[obstacle.o]\n" + keys + "\n"), [is_seen](const Problem& problem) {
                return is_seen(obstacle(problem));
            }};
}

// A curve of a tube, by where it starts and ends.
struct CurveCase {
    std::string name, deck;
    Vec3 start, end;
};

std::vector<CurveCase> list_curves() {
    return {{"arc", "from = [5, 0, -9], through = [0, 5, -9], to = [-5, 0, -9]", {5, 0, -9}, {-5, 0, -9}},
            {"arc",
             "centre = [0, 0, -9], axis = [0, 0, 1], from = [5, 0, -9], angle = \"pi\"",
             {5, 0, -9},
             {-5, 0, -9}},
            {"helix",
             "centre = [0, 0, -9], axis = [0, 0, -1], from = [2, 0, -9], turns = 2, pitch = 3",
             {2, 0, -9},
             {2, 0, -15}}};
}

void add_curve_trips(std::vector<RoundTrip>& trips) {
    for (const CurveCase& curve : list_curves()) {
        trips.push_back(trip("tube." + curve.name,
                             "tube = { " + curve.name + " = { " + curve.deck + " }, radius = 0.5 }",
                             [curve](const Obstacle& one) {
                                 const auto* tube = std::get_if<TubeShape>(&one.shape);
                                 return tube != nullptr &&
                                        (tube->line.front() - curve.start).norm() < 1e-12 &&
                                        (tube->line.back() - curve.end).norm() < 1e-12;
                             }));
    }
}

void add_move_trips(std::vector<RoundTrip>& trips) {
    for (std::size_t i = 0; i < component_names.size(); ++i) {
        const std::string name(component_names[i]);
        trips.push_back(
            trip("move." + name, floor_keys + "move = { " + name + " = \"3*t\" }", [i](const Obstacle& one) {
                if (!one.motion) return false;
                const TimeVector& part = i < 3 ? one.motion->displacement : one.motion->rotation;
                return part(0.5)[static_cast<Eigen::Index>(i % 3)] == 1.5;
            }));
    }
    trips.push_back(
        trip("move.about", floor_keys + "move = { rx = \"t\", about = [4, 5, 6] }", [](const Obstacle& one) {
            return one.motion && one.motion->about == Vec3(4, 5, 6);
        }));
}

void add_shape_trips(std::vector<RoundTrip>& trips) {
    const std::string sphere = "sphere = { centre = [0, 0, -3], radius = 0.5 }";
    const std::string cylinder = "cylinder = { from = [0, 0, -3], to = [1, 0, -3], radius = 0.5 }";
    const auto is_hollow = [](const Obstacle& one) { return one.is_hollow(); };
    const auto has_radius = [](const Obstacle& one) {
        return one.round() != nullptr && one.round()->radius == 0.5;
    };
    const auto starts = [](const Vec3& at) {
        return [at](const Obstacle& one) {
            return std::visit([](const auto& shape) { return Vec3(shape.points().front()); }, one.shape) ==
                   at;
        };
    };
    trips.push_back(trip("plane.point", floor_keys, starts({1, 2, -3})));
    trips.push_back(trip("plane.normal", floor_keys, [](const Obstacle& one) {
        return one.plane() != nullptr && one.plane()->normal == Vec3(0, 0, 1) &&
               one.plane()->point == Vec3(1, 2, -3);
    }));
    trips.push_back(trip("sphere.centre", sphere, starts({0, 0, -3})));
    trips.push_back(trip("sphere.radius", sphere, has_radius));
    trips.push_back(
        trip("sphere.side", "sphere = { centre = [0, 0, 0], radius = 50, side = \"inside\" }", is_hollow));
    trips.push_back(trip("cylinder.from", cylinder, starts({0, 0, -3})));
    trips.push_back(trip("cylinder.to", cylinder, [](const Obstacle& one) {
        const auto* own = std::get_if<CylinderShape>(&one.shape);
        return own != nullptr && own->to == Vec3(1, 0, -3);
    }));
    trips.push_back(trip("cylinder.radius", cylinder, has_radius));
    trips.push_back(trip("cylinder.side",
                         "cylinder = { from = [0, 0, 0], to = [1, 0, 0], radius = 50, side = \"inside\" }",
                         is_hollow));
    const std::string spline = "tube = { spline = [[0, 0, -9], [1, 1, -9], [2, 0, -9]], radius = 0.5 }";
    trips.push_back(trip("tube.spline", spline, starts({0, 0, -9})));
    trips.push_back(trip("tube.radius", spline, has_radius));
    trips.push_back(
        trip("tube.side",
             "tube = { spline = [[-9, 0, 0], [0, 0, 0], [9, 0, 0]], radius = 5, side = \"inside\" }",
             is_hollow));
}

// A file with a triangle, as long as the program runs.
std::string triangle_file(const char* name, const char* height) {
    static std::vector<std::unique_ptr<ScratchFile>> files;
    files.push_back(std::make_unique<ScratchFile>(
        name,
        std::string("solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 ") + height + "\nvertex 1 0 " +
            height + "\nvertex 0 1 " + height + "\nendloop\nendfacet\nendsolid s\n"));
    return files.back()->path().string();
}

// Two faces of a rounded ridge, far below.
std::string ridge_file() {
    static const ScratchFile file("ridge.stl",
                                  "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 -9\nvertex 1 0 -9\n"
                                  "vertex 0.5 1 -9.28\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\n"
                                  "vertex 1 0 -9\nvertex 0 0 -9\nvertex 0.5 -1 -9.28\nendloop\nendfacet\n"
                                  "endsolid s\n");
    return file.path().string();
}

void add_mesh_trips(std::vector<RoundTrip>& trips) {
    const std::string low = triangle_file("low.stl", "-5"), lower = triangle_file("lower.STL", "-7");
    const auto add = [&](const std::string& key, const std::string& keys, auto is_seen) {
        trips.push_back(trip("mesh." + key, "mesh = { " + keys + " }", [is_seen](const Obstacle& one) {
            return one.mesh() != nullptr && is_seen(*one.mesh());
        }));
    };
    add("file", "file = \"" + lower + "\"", [](const TriangleMesh& mesh) {
        return mesh.triangles.size() == 1 && mesh.positions.at(0) == Vec3(0, 0, -7);
    });
    add("scale", "file = \"" + low + "\", scale = 2", [](const TriangleMesh& mesh) {
        return mesh.positions.at(0) == Vec3(0, 0, -10);
    });
    add("feature_angle", "file = \"" + low + "\", feature_angle = 0.6", [](const TriangleMesh& mesh) {
        return mesh.feature_angle == 0.6;
    });
    add("smooth", "file = \"" + ridge_file() + "\", smooth = true", [](const TriangleMesh& mesh) {
        return mesh.triangles.size() > 2 && mesh.feature_angle == 0.1;
    });
}

void add_body_trips(std::vector<RoundTrip>& trips) {
    const auto add = [&](const std::string& key, const std::string& keys, const auto& is_seen) {
        trips.push_back(
            {"body.NAME." + key,
             "gravity = [0, 0, -10]\n[body.b]\nmass = 2\ninertia = [1, 1, 1]\n" + keys +
                 "\n[obstacle.o]\nplane = { point = [0, 0, -9], normal = [0, 0, 1] }\n[analysis]\n"
                 "kind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\n",
             [is_seen](const Problem& problem) {
                 const std::vector<ContactBody>& bodies = problem.model.contact.bodies;
                 return bodies.size() == 1 && is_seen(bodies[0]);
             }});
    };
    const std::string sphere = "sphere = { radius = 0.5, centre = [1, 2, 3], force = 7 }";
    const std::string capsule = "capsule = { radius = 0.5, from = [1, 2, 3], to = [3, 2, 1], force = 7 }";
    const auto has_radius = [](const ContactBody& one) { return one.radius == 0.5; };
    const auto has_force = [](const ContactBody& one) { return one.force == 7.0; };
    add("sphere.radius", sphere, has_radius);
    add("sphere.centre", sphere, [](const ContactBody& one) {
        return one.ends == std::array{Vec3(1, 2, 3), Vec3(1, 2, 3)};
    });
    add("sphere.force", sphere, has_force);
    add("capsule.radius", capsule, has_radius);
    add("capsule.from", capsule, [](const ContactBody& one) { return one.ends[0] == Vec3(1, 2, 3); });
    add("capsule.to", capsule, [](const ContactBody& one) { return one.ends[1] == Vec3(3, 2, 1); });
    add("capsule.force", capsule, has_force);
    trips.push_back({"obstacle.NAME.restitution",
                     wires("[obstacle.o]\n" + floor_keys + "restitution = 0.7\n"),
                     [](const Problem& problem) { return exception(problem).restitution == 0.7; }});
}

// Friction of [contact], of an obstacle and of a pair: each a table with the same keys.
struct Rubbing {
    double coefficient = 0.0;
    FrictionShape shape{};
};

void add_friction_trips(std::vector<RoundTrip>& trips) {
    const auto add = [&](const std::string& key,
                         const std::string& keys,
                         const std::function<bool(const Rubbing&)>& is_seen) {
        const std::string table = "friction = { " + keys + " }\n";
        trips.push_back({"contact.friction." + key,
                         wires("[contact]\n" + table + "[obstacle.o]\n" + floor_keys),
                         [is_seen](const Problem& p) {
                             const Contact& contact = p.model.contact;
                             return is_seen({contact.friction, contact.friction_shape}) &&
                                    is_seen({obstacle(p).friction, obstacle(p).friction_shape});
                         }});
        trips.push_back(trip("friction." + key, floor_keys + table, [is_seen](const Obstacle& one) {
            return is_seen({one.friction, one.friction_shape});
        }));
        trips.push_back(
            {"contact.pair.friction." + key,
             wires("[contact]\n[[contact.pair]]\nbetween = [\"a\", \"b\"]\n" + table),
             [is_seen](const Problem& p) {
                 return is_seen({exception(p).friction.value_or(0.0), exception(p).friction_shape});
             }});
    };
    const std::string weak = "static = 0.4, kinetic = 0.3, stribeck_speed = 0.02";
    const std::string scaly = "forward = 0.2, backward = 0.5, across = 0.25";
    add("static", weak, [](const Rubbing& one) { return one.coefficient == 0.4; });
    add("kinetic", weak, [](const Rubbing& one) { return std::abs(one.shape.kinetic - 0.75) < 1e-15; });
    add("stribeck_speed", weak, [](const Rubbing& one) { return one.shape.stribeck_speed == 0.02; });
    add("forward", scaly, [](const Rubbing& one) { return one.shape.forward == 0.4; });
    add("backward", scaly, [](const Rubbing& one) {
        return one.coefficient == 0.5 && one.shape.backward == 1.0;
    });
    add("across", scaly, [](const Rubbing& one) { return one.shape.across == 0.5; });
}

}  // namespace

std::vector<RoundTrip> contact_trips() {
    const auto radii = [](const Problem& p) { return p.model.contact.radii; };
    std::vector<RoundTrip> trips{
        {"contact.rods",
         wires("[contact]\nrods = \"b\"\n"),
         [=](const Problem& p) {
             return radii(p) == std::vector{0.0, 0.01};
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
        {"contact.damping",
         wires("[contact]\ndamping = 0.5\n"),
         [](const Problem& p) { return p.model.contact.damping == 0.5; }},
        {"contact.restitution",
         wires("[contact]\nrestitution = 0.5\n"),
         [](const Problem& p) { return exception(p).restitution == 0.5; }},
        {"contact.pair.restitution",
         wires("[contact]\n[[contact.pair]]\nbetween = [\"a\", \"b\"]\nrestitution = 0.2\n"),
         [](const Problem& p) { return exception(p).restitution == 0.2; }},
        {"contact.pair.between",
         wires("[contact]\n[[contact.pair]]\nbetween = [\"*@0.5..1\", \"b\"]\noff = true\n"),
         [](const Problem& p) {
             const auto& [first, second] = exception(p).between;
             return first.size() == 2 && first[0].index == 0 && first[1].index == 1 && first[1].from == 0.5 &&
                    first[1].to == 1.0 && second.size() == 1 && second[0].index == 1 && second[0].from == 0.0;
         }},
        {"contact.pair.friction",
         wires("[contact]\n[[contact.pair]]\nbetween = [\"a\", \"b\"]\nfriction = 0.2\n"),
         [](const Problem& p) { return exception(p).friction == 0.2; }},
        {"contact.pair.off",
         wires("[contact]\n[[contact.pair]]\nbetween = [\"a\", \"b\"]\noff = true\n"),
         [](const Problem& p) { return exception(p).is_off; }},
        {"section.NAME.radius",
         wires("[contact]\n", "radius = 0.03\n"),
         [=](const Problem& p) {
             return radii(p) == std::vector{0.03, 0.03};
         }},
        {"history.with",
         wires(
             "[contact]\n[[history]]\nname = \"h\"\nat = \"a\"\nwith = \"b\"\nquantities = \"least_gap\"\n"),
         [](const Problem& p) {
             const HistoryRequest& request = p.output.histories[0];
             const ContactWatch* contact = contact_of(request.target);
             return request.with == "b" && contact != nullptr && contact->rod == 0 && contact->other == 1 &&
                    contact->wants_gap;
         }},
        trip("friction",
             floor_keys + "friction = 0.7",
             [](const Obstacle& one) { return one.friction == 0.7; }),
        trip("stiffness", floor_keys + "stiffness = 30", [](const Obstacle& one) {
            return one.stiffness == 30.0;
        })};
    add_shape_trips(trips);
    add_curve_trips(trips);
    add_move_trips(trips);
    add_mesh_trips(trips);
    add_body_trips(trips);
    add_friction_trips(trips);
    return trips;
}

}  // namespace gxrod::test
