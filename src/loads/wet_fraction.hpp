#pragma once

#include "environment/fluid_field.hpp"

namespace gxrod {

// The share of a piece of a rod, or of a body, in the water: from 0 to 1.
struct WetFraction {
    double value = 0.0;
    Vec3 by_place = Vec3::Zero();  // derivative by the place of the water together with the piece
    Vec3 by_spin = Vec3::Zero();   // derivative by a spatial spin of the piece
};

// Computes the share. `water` is null without water; water without a surface is everywhere. `z` is the height
// of the place. The piece has its middle at `offset` from there along `axis`, of length 1; its extent is
// `length` along the axis and `width` across, not 0.
WetFraction compute_wet_fraction(
    const WaterAt* water, double z, const Vec3& axis, double offset, double length, double width);

// Computes the share of a body with its centre at `z`, which sinks in over `height`; without height, at once.
WetFraction compute_wet_fraction(const WaterAt* water, double z, double height);

}  // namespace gxrod
