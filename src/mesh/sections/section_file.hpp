#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cross_section/section_mesh.hpp"
#include "mesh/sections/surface_file.hpp"

namespace gxrod {

// The direction t of each surface by data of a file: an angle from y towards z, of the surface or of each of
// its nodes.
struct WallAngles {
    int data = 0;  // an index in SurfaceMesh::data
};

// Describes what the surfaces of a physical group are made of.
struct SectionGroup {
    int group = -1;  // an index in SurfaceMesh::groups; −1: all surfaces of a mesh, whatever their groups
    std::string name;
    int material = 0;
    double fibre_angle = 0.0;
    // The direction t: an angle from y towards z, the index of a group of curves whose nearest tangent it is,
    // or data.
    std::variant<double, int, WallAngles> wall = 0.0;
};

// Makes a section from a mesh that lies in a plane: z constant (its x and y become y and z of the section) or
// x constant (its y and z). Layers are the groups, in their order. Surfaces without a group here are left out
// of the section. Throws MeshError.
SectionMesh make_section_mesh(const SurfaceMesh& mesh, double scale, const std::vector<SectionGroup>& groups);

}  // namespace gxrod
