#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/line_mesh.hpp"

// Elements of surfaces and curves of a mesh file, as it has them.
namespace gxrod {

// A physical group of surfaces (dimension 2) or curves (1).
struct SurfaceGroup {
    int dimension = 2, number = 0;
    std::string name;  // "" if it has none

    // Returns its name for users.
    std::string title() const { return name_of_group(number, name); }
};

struct SurfaceElement {
    int type = 0;    // as the MSH format numbers types
    int group = -1;  // an index in SurfaceMesh::groups; −1: in none
    std::vector<int> nodes = {};
    std::size_t number = 0;  // in the file
};

// Numbers on surfaces ($ElementData, $ElementNodeData of a file): one for each surface, or one for each of
// its nodes.
struct SurfaceData {
    std::string name;
    std::vector<std::vector<double>> values;  // of SurfaceMesh::surfaces; empty where the file has none
};

struct SurfaceMesh {
    std::vector<Vec3> positions;
    std::vector<SurfaceGroup> groups;
    std::vector<SurfaceElement> surfaces;  // each once
    std::vector<SurfaceElement> curves;    // of groups; once for each
    std::vector<SurfaceData> data = {};
};

// Reads a file through libgmsh: .msh of any version. Throws MeshError, also if a surface is in two groups.
SurfaceMesh read_surface_mesh(const std::filesystem::path& file);

}  // namespace gxrod
