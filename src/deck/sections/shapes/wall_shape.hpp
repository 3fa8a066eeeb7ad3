#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cross_section/elastic_material.hpp"
#include "deck/places/build_context.hpp"
#include "deck/sections/shapes/wall_tables.hpp"
#include "mesh/sections/surface_file.hpp"

// Sections of walls of plies, and of meshes.
namespace gxrod {

// A section that is meshed, with the materials of its layers.
struct MeshedShape {
    std::string source;  // what it is, for people: "walls", "station12.msh"
    SectionMesh mesh;
    std::vector<ElasticMaterial> materials;
};

// Meshes walls. With a fault, nullopt.
std::optional<MeshedShape> mesh_walls_of(const WallsTable& given, const BuildContext& context);

// Makes a section of a file that has been read. With a fault, nullopt.
std::optional<MeshedShape> mesh_file_of(const MeshShapeTable& given,
                                        const SurfaceMesh& file,
                                        const BuildContext& context);

// Reads the files of a deck's sections, and keeps their bytes. With a fault, a section has none.
std::map<std::string, std::shared_ptr<const SurfaceMesh>> read_section_meshes(
    const CheckedTable& deck, const MeshFiles& files, FaultList& faults, std::vector<MeshRecord>& records);

}  // namespace gxrod
