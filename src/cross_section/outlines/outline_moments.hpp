#pragma once

#include "cross_section/outlines/outline.hpp"

namespace gxrod {

// Area and moments of area of a cross-section. Second moments are about axes through the centroid, along y
// and z.
struct OutlineMoments {
    double area = 0.0;
    PlanePoint centroid = PlanePoint::Zero();
    double Iy = 0.0;   // ∫ z² dA
    double Iz = 0.0;   // ∫ y² dA
    double Iyz = 0.0;  // ∫ y z dA
};

// Computes the moments of an outline by Green's theorem, to round-off.
OutlineMoments compute_moments(const Outline& outline);

}  // namespace gxrod
