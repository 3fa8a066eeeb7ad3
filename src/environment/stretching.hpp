#pragma once

#include <optional>

#include "model/surroundings.hpp"

// Stretching: continues linear waves and currents to the moving surface (docs/theory/water.md). Heights are
// from still water, upwards; `depth` is the depth of the bed below it, if there is one.
namespace gxrod {

struct WaveSurface {
    double elevation = 0.0;
    Vec3 slope = Vec3::Zero();  // its gradient; z component 0
};

// The height at which a formula is evaluated for a place, and its gradient by the place.
struct FormulaHeight {
    double z = 0.0;
    Vec3 gradient = Vec3::UnitZ();
};

// Applies Wheeler's stretching: it maps the water from the bed to the surface linearly to the water from the
// bed to still water; in deep water it shifts it. Places above the surface take the value at the surface,
// places below the bed the value at the bed.
FormulaHeight draw_to_still_water(double z, std::optional<double> depth, const WaveSurface& surface);

FormulaHeight find_formula_height(Stretching stretching,
                                  double z,
                                  std::optional<double> depth,
                                  const WaveSurface& surface);

}  // namespace gxrod
