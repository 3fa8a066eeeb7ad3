#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "contact/meshes/mesh_surface.hpp"
#include "numerics/disjoint_sets.hpp"

// Edges of meshes: where they are sharp, and how close together places of a rod have to be.
namespace gxrod {
namespace {

struct MeshEdge {
    int from = 0, to = 0;         // corners
    int first = -1, second = -1;  // triangles
    bool has_more = false;
};

std::vector<MeshEdge> find_edges(const TriangleMesh& mesh) {
    struct Side {
        int from, to, triangle;
    };
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t)});
        }
    }
    std::ranges::sort(sides, [](const Side& a, const Side& b) {
        return std::tie(a.from, a.to, a.triangle) < std::tie(b.from, b.to, b.triangle);
    });
    std::vector<MeshEdge> edges;
    for (const Side& side : sides) {
        if (edges.empty() || edges.back().from != side.from || edges.back().to != side.to) {
            edges.push_back({side.from, side.to, side.triangle});
        } else if (edges.back().second < 0) {
            edges.back().second = side.triangle;
        } else {
            edges.back().has_more = true;
        }
    }
    return edges;
}

const Vec3& position(const TriangleMesh& mesh, int corner) {
    return mesh.positions[static_cast<std::size_t>(corner)];
}

// From an edge towards the middle of a triangle, along it.
struct Inwards {
    Vec3 direction;
    double height;  // of the triangle over the edge
};
Inwards find_inwards(const TriangleMesh& mesh, const MeshEdge& edge, int triangle) {
    const std::array<int, 3>& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
    const int apex = *std::ranges::find_if(corners, [&](int c) { return c != edge.from && c != edge.to; });
    const Vec3 along = (position(mesh, edge.to) - position(mesh, edge.from)).normalized();
    const Vec3 offset = position(mesh, apex) - position(mesh, edge.from);
    const Vec3 across = offset - offset.dot(along) * along;
    return {across.stableNormalized(), across.norm()};
}

// By how much the surface turns there: 0 of a plane, π at its end. The order of corners does not matter.
struct Bend {
    double turn = M_PI;
    double width = 0.0;  // of the triangles there, their mean
};
Bend find_bend(const TriangleMesh& mesh, const MeshEdge& edge) {
    if (edge.second < 0 || edge.has_more) return {};
    const Inwards a = find_inwards(mesh, edge, edge.first), b = find_inwards(mesh, edge, edge.second);
    const double turn = std::atan2(a.direction.cross(b.direction).norm(), -a.direction.dot(b.direction));
    return {turn, 0.5 * (a.height + b.height)};
}

// Regions that share a corner get different colours, the first that is left.
std::map<int, int> colour(const TriangleMesh& mesh, DisjointSets& regions) {
    std::vector<std::set<int>> at_corners(mesh.positions.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int corner : mesh.triangles[t])
            at_corners[static_cast<std::size_t>(corner)].insert(regions.find(static_cast<int>(t)));
    std::map<int, std::set<int>> neighbours;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) neighbours[regions.find(static_cast<int>(t))];
    for (const std::set<int>& here : at_corners)
        for (const int region : here) neighbours[region].insert(here.begin(), here.end());
    std::map<int, int> colours;
    for (const auto& [region, others] : neighbours) {
        std::set<int> taken;
        for (const int other : others)
            if (other != region && colours.contains(other)) taken.insert(colours[other]);
        int own = 0;
        while (taken.contains(own)) ++own;
        colours[region] = own;
    }
    return colours;
}

}  // namespace

std::vector<std::shared_ptr<const MeshSurface>> split_at_sharp_edges(const TriangleMesh& mesh) {
    DisjointSets regions(mesh.triangles.size());
    for (const MeshEdge& edge : find_edges(mesh))
        if (edge.second >= 0 && !edge.has_more && find_bend(mesh, edge).turn <= mesh.feature_angle)
            regions.join(edge.first, edge.second);
    const std::map<int, int> colours = colour(mesh, regions);
    std::vector<std::vector<int>> parts;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto own = static_cast<std::size_t>(colours.at(regions.find(static_cast<int>(t))));
        if (own >= parts.size()) parts.resize(own + 1);
        parts[own].push_back(static_cast<int>(t));
    }
    std::vector<std::shared_ptr<const MeshSurface>> surfaces;
    for (std::vector<int>& part : parts)
        surfaces.push_back(std::make_shared<MeshSurface>(mesh, std::move(part)));
    return surfaces;
}

// A straight rod over an edge that turns by β is nearer to it there than at the places next to it, h apart,
// by β h/4 − r β²/8, or h²/(8 r) if they are within the edge's own angle; over several edges, as far apart as
// wide, by h²/8 (width/β + r)⁻¹.
double find_mesh_spacing(const TriangleMesh& mesh, double radius, double skin) {
    double spacing = std::numeric_limits<double>::infinity();
    constexpr double flat = 1e-9;
    for (const MeshEdge& edge : find_edges(mesh)) {
        const Bend bend = find_bend(mesh, edge);
        const double turn = bend.turn;
        if (turn < flat) continue;
        double own = std::sqrt(skin * radius);
        if (turn < std::sqrt(skin / radius)) {
            const double of_edge = 0.5 * (skin / turn + radius * turn);
            const double of_arc = std::sqrt(skin * (bend.width / turn + radius));
            own = std::min(of_edge, std::max(bend.width, of_arc));
        }
        spacing = std::min(spacing, own);
    }
    return spacing;
}

}  // namespace gxrod
