#include "mesh/sections/plane_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "machine/child_process.hpp"
#include "mesh/gmsh_session.hpp"

namespace gxrod {
namespace {

// Element types of Gmsh.
constexpr int line_type = 1, triangle_type = 2;

using PointIndex = std::map<std::size_t, int>;  // by Gmsh's number of a node

// Numbers the corners of the loops: the nodes at which the lines start.
void number_corners(const GmshSession& session, const std::vector<int>& lines, PointIndex& index) {
    for (const int line : lines) {
        const std::vector<GmshElements> elements = session.elements_of_entity(1, line);
        if (elements.size() != 1 || elements[0].type != line_type || elements[0].nodes.size() != 2)
            throw MeshError("Gmsh has divided a side of the outline");
        const auto count = static_cast<int>(index.size());
        index.emplace(elements[0].nodes[0], count);
    }
}

PlaneTriangles read_triangles(const GmshSession& session, PointIndex& index) {
    const GmshSession::Nodes nodes = session.nodes();
    for (const std::size_t number : nodes.numbers) {
        const auto count = static_cast<int>(index.size());
        index.emplace(number, count);
    }
    PlaneTriangles mesh;
    mesh.points.resize(index.size());
    for (std::size_t i = 0; i < nodes.numbers.size(); ++i)
        mesh.points[static_cast<std::size_t>(index.at(nodes.numbers[i]))] = nodes.positions[i].head<2>();
    for (const GmshElements& elements : session.elements_of_entity(2, -1)) {
        if (elements.type != triangle_type) throw MeshError("Gmsh has made elements that are no triangles");
        for (std::size_t i = 0; i + 2 < elements.nodes.size(); i += 3) {
            const auto node = [&](std::size_t k) { return index.at(elements.nodes[i + k]); };
            mesh.triangles.push_back({node(0), node(1), node(2)});
        }
    }
    return mesh;
}

// Turns triangles to be walked anticlockwise: Gmsh turns them as the outline is.
void turn_anticlockwise(PlaneTriangles& mesh) {
    for (auto& [a, b, c] : mesh.triangles) {
        const auto at = [&](int i) { return mesh.points[static_cast<std::size_t>(i)]; };
        const PlanePoint one = at(b) - at(a), other = at(c) - at(a);
        if (one.x() * other.y() < one.y() * other.x()) std::swap(b, c);
    }
}

// The greatest distance of a corner from the first one: Gmsh has tolerances for lengths about 1.
double measure_extent(const PlaneLoop& outer) {
    double extent = 0.0;
    for (const PlanePoint& corner : outer.corners)
        extent = std::max(extent, (corner - outer.corners[0]).norm());
    return extent;
}

// Equal shapes get equal meshes, whatever their unit and place.
double leave_out_round_off(double value) {
    constexpr double steps = 1099511627776.0;  // 2⁴⁰
    return std::round(value * steps) / steps;
}

// The mesh of an area seen from its first corner, over its extent.
PlaneTriangles mesh_with_gmsh(const GmshLibrary& gmsh, const std::vector<PlaneLoop>& loops) {
    const PlanePoint origin = loops[0].corners[0];
    const double extent = measure_extent(loops[0]);
    GmshSession session(gmsh);
    session.begin_area();
    std::vector<int> lines;
    for (PlaneLoop loop : loops) {
        for (PlanePoint& corner : loop.corners)
            corner = ((corner - origin) / extent).unaryExpr(&leave_out_round_off);
        for (double& size : loop.sizes) size = leave_out_round_off(size / extent);
        const std::vector<int> of_loop = session.add_loop(loop.corners, loop.sizes);
        lines.insert(lines.end(), of_loop.begin(), of_loop.end());
    }
    session.generate_triangles();
    PointIndex index;
    number_corners(session, lines, index);
    PlaneTriangles mesh = read_triangles(session, index);
    if (mesh.triangles.empty()) throw MeshError("Gmsh has made no triangles");
    turn_anticlockwise(mesh);
    return mesh;
}

constexpr char is_triangles = 't';
constexpr char is_failure = 'e';

std::string to_bytes(const PlaneTriangles& mesh) {
    const std::size_t count = mesh.points.size();
    std::string bytes(1 + sizeof(count), is_triangles);
    std::memcpy(bytes.data() + 1, &count, sizeof(count));
    bytes.append(reinterpret_cast<const char*>(mesh.points.data()), count * sizeof(PlanePoint));
    return bytes.append(reinterpret_cast<const char*>(mesh.triangles.data()),
                        mesh.triangles.size() * sizeof(mesh.triangles[0]));
}

PlaneTriangles from_bytes(std::string_view bytes) {
    std::size_t count = 0;
    if (bytes.size() < sizeof(count)) throw MeshError("what Gmsh has made of it is cut short");
    std::memcpy(&count, bytes.data(), sizeof(count));
    bytes.remove_prefix(sizeof(count));
    if (bytes.size() / sizeof(PlanePoint) < count) throw MeshError("what Gmsh has made of it is cut short");
    PlaneTriangles mesh;
    mesh.points.resize(count);
    std::memcpy(static_cast<void*>(mesh.points.data()), bytes.data(), count * sizeof(PlanePoint));
    bytes.remove_prefix(count * sizeof(PlanePoint));
    mesh.triangles.resize(bytes.size() / sizeof(mesh.triangles[0]));
    std::memcpy(mesh.triangles.data(), bytes.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
    return mesh;
}

std::string answer_triangles(const GmshLibrary& gmsh, const std::vector<PlaneLoop>& loops) {
    try {
        return to_bytes(mesh_with_gmsh(gmsh, loops));
    } catch (const MeshError& error) {
        return is_failure + std::string(error.what());
    }
}

}  // namespace

// Gmsh has one memory per process, and it may crash: so it works in a process of its own.
PlaneTriangles mesh_area(const std::vector<PlaneLoop>& loops, const GmshLibrary& gmsh) {
    constexpr int most_seconds = 600;
    std::string said;
    try {
        said = run_in_child([&] { return answer_triangles(gmsh, loops); },
                            {.processor_seconds = most_seconds, .waiting_seconds = 30, .reads_only = true});
    } catch (const ChildError& error) {
        throw MeshError(std::string("Gmsh cannot mesh it: ") + error.what());
    }
    const std::string_view content = std::string_view(said).substr(std::min<std::size_t>(1, said.size()));
    if (said.empty() || said[0] != is_triangles) throw MeshError(std::string(content));
    PlaneTriangles mesh = from_bytes(content);
    const double extent = measure_extent(loops[0]);
    for (PlanePoint& point : mesh.points) point = loops[0].corners[0] + extent * point;
    std::size_t first = 0;
    for (const PlaneLoop& loop : loops) {
        std::ranges::copy(loop.corners, mesh.points.begin() + static_cast<std::ptrdiff_t>(first));
        first += loop.corners.size();
    }
    return mesh;
}

}  // namespace gxrod
