#include <cmath>
#include <memory>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"

namespace gxrod::test {
namespace {

// Returns an STL file of one triangle of edges 1; the same file for all.
std::string triangle_file() {
    static const ScratchFile file("look.stl",
                                  "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                  "vertex 0 1 0\nendloop\nendfacet\nendsolid s\n");
    return file.path().string();
}

// The largest coordinate of an outline along an axis.
double reach(const BodyOutline& outline, int axis) {
    double most = -1e300;
    for (const Vec3& point : outline.points) most = std::max(most, point[axis]);
    return most;
}

RoundTrip trip(const std::string& key, const std::string& part, int axis, double reached) {
    const std::string hold = "looks = [{ " + part +
                             " }]\n[spring.s]\nbetween = [\"top\", \"ground\"]\n"
                             "at_a = [0, 7, 0]\nat_b = [0, 9, 0]\nstiffness = 1\n";
    return {"body.NAME.looks." + key, with_body_key(hold), [=](const Problem& problem) {
                const BodyOutline& own = problem.outlines.at(0);
                return own.is_given && std::abs(reach(own, axis) - reached) < 1e-12;
            }};
}

}  // namespace

std::vector<RoundTrip> looks_trips() {
    const std::string mesh = "mesh = { file = \"" + triangle_file() + "\"";
    const std::string turn = ", rotation_vector = [0, 0, \"pi/2\"] }";
    const std::string cylinder = "cylinder = { from = [4, 0, 0], to = [2, 0, 0], radius = 3 }";
    const std::string sphere = "sphere = { radius = 2, centre = [5, 0, 0] }";
    return {trip("box.size", "box = { size = [1, 2, 3] }", 2, 1.5),
            trip("box.at", "box = { size = [2, 2, 2], at = [4, 0, 0] }", 0, 5),
            trip("box.rotation_vector", "box = { size = [2, 4, 6]" + turn, 0, 2),
            trip("cylinder.from", cylinder, 0, 4),
            trip("cylinder.to", "cylinder = { from = [4, 0, 0], to = [6, 0, 0], radius = 3 }", 0, 6),
            trip("cylinder.radius", cylinder, 1, 3),
            trip("sphere.radius", sphere, 2, 2),
            trip("sphere.centre", sphere, 1, 2),
            trip("arms", "arms = 1.5", 1, 8.5),
            trip("mesh.file", mesh + " }", 0, 1),
            trip("mesh.scale", mesh + ", scale = 3 }", 1, 3),
            trip("mesh.at", mesh + ", at = [0, 0, 6] }", 2, 6),
            trip("mesh.rotation_vector", mesh + turn, 1, 1)};
}

}  // namespace gxrod::test
