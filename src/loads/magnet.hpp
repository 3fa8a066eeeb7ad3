#pragma once

#include "model/model.hpp"

namespace gxrod {

// A magnetic moment at a place in a field, spatial. Of a field by place, which has no derivatives of its own,
// differences are taken over a small part of `length`, over which it should be smooth.
struct Magnet {
    const MagneticField& field;
    double time;
    Vec3 position;
    Vec3 moment;
    double length;
};

// Its potential is −μ · B. The force (∇B)ᵀ μ and the couple μ × B, stacked.
Vec6 compute_magnetic_load(const Magnet& magnet);

// Their derivative by (δr, δφ), where the moment turns with φ.
Mat6 compute_magnetic_tangent(const Magnet& magnet);

}  // namespace gxrod
