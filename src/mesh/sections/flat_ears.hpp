#pragma once

#include "mesh/sections/plane_triangles.hpp"

namespace gxrod {

// Divides triangles that have two sides on the boundary which go on nearly straight, with the triangle on
// their third side, about a point in the middle: bent to a smooth boundary, they would have an angle of π.
void divide_flat_ears(PlaneTriangles& mesh);

}  // namespace gxrod
