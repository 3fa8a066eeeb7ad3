#include "loads/wet_fraction.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {
namespace {

// `above`: of the surface, over the middle of what is `height` tall.
WetFraction sink(const WaterAt& water, double above, double height) {
    WetFraction wet;
    wet.value = std::clamp(0.5 + above / height, 0.0, 1.0);
    if (wet.value > 0.0 && wet.value < 1.0) wet.by_place = (water.surface_slope - Vec3::UnitZ()) / height;
    return wet;
}

bool has_surface(const WaterAt* water) { return water && water->has_surface; }

WetFraction everywhere(const WaterAt* water) {
    WetFraction wet;
    wet.value = water ? 1.0 : 0.0;
    return wet;
}

}  // namespace

WetFraction compute_wet_fraction(
    const WaterAt* water, double z, const Vec3& axis, double offset, double length, double width) {
    if (!has_surface(water)) return everywhere(water);
    const double upright = axis.z();
    const double square = width * width + (length * length - width * width) * upright * upright;
    const double height = std::sqrt(square);
    const double above = water->surface - z - offset * upright;
    WetFraction wet = sink(*water, above, height);
    if (wet.value > 0.0 && wet.value < 1.0) {
        const double by_height = -above / square * (length * length - width * width) * upright / height;
        wet.by_spin = (by_height - offset / height) * axis.cross(Vec3::UnitZ());
    }
    return wet;
}

WetFraction compute_wet_fraction(const WaterAt* water, double z, double height) {
    if (!has_surface(water)) return everywhere(water);
    const double above = water->surface - z;
    if (height > 0.0) return sink(*water, above, height);
    WetFraction wet;
    wet.value = above > 0.0 ? 1.0 : 0.0;
    return wet;
}

}  // namespace gxrod
