#pragma once

#include <optional>

#include "model/surroundings.hpp"

// How linear waves and currents are continued to the moving surface (docs/theory/water.md). Heights are from
// still water, upwards; `depth` is that of the bed below it, if there is one.
namespace gxrod {

struct WaveSurface {
    double elevation = 0.0;
    Vec3 slope = Vec3::Zero();  // its gradient; z component 0
};

// The height at which a formula is used for a place, and its gradient by the place.
struct FormulaHeight {
    double z = 0.0;
    Vec3 gradient = Vec3::UnitZ();
};

// Wheeler's: the water from the bed to the surface is drawn to that from the bed to still water; in deep
// water it is moved. Above the surface as at it, below the bed as at the bed.
FormulaHeight draw_to_still_water(double z, std::optional<double> depth, const WaveSurface& surface);

FormulaHeight find_formula_height(Stretching stretching,
                                  double z,
                                  std::optional<double> depth,
                                  const WaveSurface& surface);

}  // namespace gxrod
