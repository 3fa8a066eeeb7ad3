#include "deck/contact/read_obstacle_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/contact/obstacle_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/table/table.hpp"
#include "deck/text/table_files.hpp"
#include "mesh/line_mesh.hpp"
#include "mesh/triangles/rounded_triangles.hpp"
#include "mesh/triangles/stl_file.hpp"
#include "mesh/triangles/triangle_edges.hpp"
#include "mesh/triangles/triangle_file.hpp"

namespace gxrod {
namespace {

constexpr double usual_angle = 0.1, smooth_angle = 0.6;

std::string describe(const TriangleMesh& mesh) {
    std::string text = fmt::format("{}: {} triangles, {} open edge{}",
                                   mesh.file,
                                   mesh.triangles.size(),
                                   mesh.open_edges,
                                   mesh.open_edges == 1 ? "" : "s");
    if (mesh.left_out > 0) text += fmt::format(", {} without area left out", mesh.left_out);
    if (mesh.repeated > 0) text += fmt::format(", {} repeated ones left out", mesh.repeated);
    return text + "; nothing is inside or outside: both sides stop rods";
}

// Of a facetted surface that looks like a curved one: most of its edges that turn at all are not sharp to the
// eye.
std::string suggest_rounding(const TriangleMesh& mesh) {
    std::size_t turned = 0, blunt = 0;
    double greatest = 0.0;
    for (const auto& [edge, sides] : list_sides(mesh)) {
        if (sides.size() != 2) continue;
        const double turn = find_turn(mesh, sides);
        constexpr double flat = 0.01;
        turned += turn > flat ? 1 : 0;
        if (turn <= mesh.feature_angle || turn > smooth_angle) continue;
        ++blunt;
        greatest = std::max(greatest, turn);
    }
    if (blunt == 0 || 4 * blunt < turned) return {};
    return fmt::format(
        "{}: {} edges turn by {:.2g} to {:.2g} and count as sharp; if the facets stand for a curved surface, "
        "smooth = true rounds them",
        mesh.file,
        blunt,
        mesh.feature_angle,
        greatest);
}

TriangleMesh round(TriangleMesh mesh, std::vector<std::string>& notes) {
    RoundedTriangles rounded = round_triangles(mesh);
    notes.push_back(
        rounded.mesh.triangles.size() == mesh.triangles.size()
            ? mesh.file + ": no edge to round; smooth has no effect"
            : fmt::format("{}: rounded into {} triangles, which stand off its facets by up to {:.3g}",
                          mesh.file,
                          rounded.mesh.triangles.size(),
                          rounded.depth));
    // What is left of the facets is touched one by one: slopes of a place between two of them change less.
    rounded.mesh.feature_angle = std::min(mesh.feature_angle, usual_angle);
    return std::move(rounded.mesh);
}

}  // namespace

std::map<std::string, std::shared_ptr<const TriangleMesh>> read_obstacle_meshes(
    const CheckedTable& deck,
    const MeshFiles& files,
    FaultList& faults,
    std::vector<MeshRecord>& records,
    std::vector<std::string>& notes) {
    std::map<std::string, std::shared_ptr<const TriangleMesh>> meshes;
    for (const ObstacleTable& obstacle : tables_of<ObstacleTable>(deck, obstacle_table())) {
        if (!obstacle.mesh) continue;
        const MeshObstacleTable& table = *obstacle.mesh;
        const std::string& file = table.file;
        const std::filesystem::path path = files.find(file);
        try {
            TriangleMesh mesh = read_triangle_mesh(path, table.scale);
            mesh.file = file;
            mesh.feature_angle = table.feature_angle.value_or(table.smooth ? smooth_angle : usual_angle);
            const std::string bytes = read_mesh_file(path);
            keep_file(file, bytes, records);
            notes.push_back(describe(mesh));
            if (is_stl(path) && lacks_end_of_stl(bytes))
                notes.push_back(file + " has a solid without endsolid: the rest of the file may be lost");
            if (table.smooth) {
                mesh = round(std::move(mesh), notes);
            } else if (std::string hint = suggest_rounding(mesh); !hint.empty() && !table.feature_angle) {
                notes.push_back(std::move(hint));
            }
            meshes.emplace(obstacle.name, std::make_shared<const TriangleMesh>(std::move(mesh)));
        } catch (const MeshError& error) {
            faults.add(table.place_of(&table.file),
                       table.path_of(&table.file),
                       fmt::format("{}: {}", path.string(), error.what()));
        }
    }
    return meshes;
}

}  // namespace gxrod
