#pragma once

#include "environment/fluid_field.hpp"

namespace gxrod {

// How much of a piece of a rod, or of a body, is in the water: from 0 to 1.
struct WetFraction {
    double value = 0.0;
    Vec3 by_place = Vec3::Zero();  // its derivative by the place of the water, with the piece
    Vec3 by_spin = Vec3::Zero();   // and by a spatial spin of the piece
};

// Water is null where there is none; without a surface it is everywhere. `z`: height of the place. The piece
// has its middle at `offset` from there along `axis`, of length 1; its extent is `length` along the axis and
// `width` across, not 0.
WetFraction compute_wet_fraction(
    const WaterAt* water, double z, const Vec3& axis, double offset, double length, double width);

// Of a body with its centre at `z`, which sinks in over `height`; without one, at once.
WetFraction compute_wet_fraction(const WaterAt* water, double z, double height);

}  // namespace gxrod
