#pragma once

#include "cross_section/section_mesh.hpp"
#include "mesh/sections/surface_file.hpp"

// The direction t of walls in a cell, by angles from y towards z.
namespace gxrod {

void paint_by_angle(double angle, SectionCell& cell);

// Takes the angles that data of a file have for a surface, whose cell this is: one for all of it, or one for
// each of its nodes, between which they are interpolated. Throws MeshError if there are no such.
void paint_by_data(const SurfaceMesh& mesh, std::size_t surface, const SurfaceData& data, SectionCell& cell);

}  // namespace gxrod
