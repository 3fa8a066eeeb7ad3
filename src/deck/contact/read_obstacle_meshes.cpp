#include "deck/contact/read_obstacle_meshes.hpp"

#include <fmt/format.h>

#include "deck/contact/obstacle_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/table/table.hpp"
#include "deck/text/table_files.hpp"
#include "mesh/line_mesh.hpp"
#include "mesh/stl_file.hpp"
#include "mesh/triangle_file.hpp"

namespace gxrod {
namespace {

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
            mesh.feature_angle = table.feature_angle;
            const std::string bytes = read_mesh_file(path);
            keep_file(file, bytes, records);
            notes.push_back(describe(mesh));
            if (is_stl(path) && lacks_end_of_stl(bytes))
                notes.push_back(file + " has a solid without endsolid: the rest of the file may be lost");
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
