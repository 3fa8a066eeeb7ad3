#pragma once

#include "model/model.hpp"

namespace gxrod {

// A magnetic moment at a place in a field, spatial. Derivatives of a field by place are differences over a
// small part of `length`, over which it should be smooth.
struct Magnet {
    const MagneticField& field;
    double time;
    Vec3 position;
    Vec3 moment;
    double length;
};

// Computes the force (∇B)ᵀ μ and the couple μ × B, stacked; the potential is −μ · B.
Vec6 compute_magnetic_load(const Magnet& magnet);

// Computes their derivative by (δr, δφ), if the moment turns with φ.
Mat6 compute_magnetic_tangent(const Magnet& magnet);

}  // namespace gxrod
