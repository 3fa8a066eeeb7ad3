#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "rotation/types.hpp"

// The data that gxrod reads from a mesh file.
namespace gxrod {

// Line elements of a 1-dimensional physical group. Nodes are indices of LineMesh::positions.
struct MeshLines {
    int number = 0;
    std::string name;         // "" if it has none
    std::vector<int> orders;  // orders of its elements, each once, increasing
    std::vector<std::size_t>
        nodes;                     // if there is one order, 1 to 3: order + 1 per element, from start to end
    std::vector<int> curves = {};  // the number of the geometry's curve, per element
};

// The nodes of a 0-dimensional physical group.
struct MeshPoints {
    int number = 0;
    std::string name;
    std::vector<std::size_t> nodes;
};

// A physical group of surfaces or volumes.
struct MeshRegion {
    int number = 0;
    std::string name;
    int dimension = 2;
};

struct LineMesh {
    std::vector<Vec3> positions;
    std::vector<MeshLines> lines;
    std::vector<MeshPoints> points;
    std::vector<MeshRegion> regions;
};

// A mesh that cannot be read; what() is a sentence without the file's name.
class MeshError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Reads a file through libgmsh: .msh of any version, or geometry, which is meshed if it has no mesh. Throws
// MeshError.
LineMesh read_line_mesh(const std::filesystem::path& file);

// Returns a group's name for users: its name, or its number if it has none.
std::string name_of_group(int number, const std::string& name);

}  // namespace gxrod
