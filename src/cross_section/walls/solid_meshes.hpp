#pragma once

#include "cross_section/section_mesh.hpp"

// Meshes of simple shapes about (0, 0), by quadrilaterals of one layer, whose material is the first one and
// whose wall direction t is y everywhere.
namespace gxrod {

struct SolidMeshSettings {
    int order = 3;
    double refinement = 1.0;  // 2 halves the elements
};

SectionMesh mesh_circle(double radius, const SolidMeshSettings& settings = {});

SectionMesh mesh_tube(double outer_radius, double inner_radius, const SolidMeshSettings& settings = {});

SectionMesh mesh_rectangle(double width_y, double height_z, const SolidMeshSettings& settings = {});

}  // namespace gxrod
