#pragma once

#include <span>
#include <vector>

#include "geometry/polynomial_curve.hpp"

namespace gxrod {

// The interpolating cubic spline through two points or more, neighbours different: its second derivative by
// the parameter is continuous and vanishes at both ends (natural ends); the parameter is the length of the
// polygon of the points (chord-length parametrisation). One cubic between neighbours.
std::vector<Cubic> compute_natural_spline(std::span<const Vec3> points);

}  // namespace gxrod
