#pragma once

#include "cross_section/outlines/outline.hpp"
#include "cross_section/section_mesh.hpp"
#include "mesh/gmsh_library.hpp"
#include "mesh/sections/boundary_division.hpp"

namespace gxrod {

// Meshes an outline without a fault by triangles of one order, whose nodes on arcs of the outline lie on
// them. The mesh has one layer, of this name and material 0. Throws MeshError.
SectionMesh mesh_outline(const Outline& outline,
                         const std::string& layer,
                         int order = 3,
                         const SectionMeshSize& size = {},
                         const GmshLibrary& gmsh = gmsh_library());

}  // namespace gxrod
