#pragma once

#include <span>
#include <vector>

#include "geometry/polynomial_curve.hpp"

namespace gxrod {

// Computes the interpolating cubic spline through two points or more, neighbours different. Its second
// derivative by the parameter is continuous and vanishes at both ends (natural ends); the parameter is the
// length of the polygon of the points (chord-length parametrisation). There is one cubic between neighbours.
std::vector<Cubic> compute_natural_spline(std::span<const Vec3> points);

}  // namespace gxrod
