#include "environment/stretching.hpp"

namespace gxrod {

namespace {

FormulaHeight hold_at(double z) { return {z, Vec3::Zero()}; }

// Up to still water, or to the surface if that is higher: there is no water above.
FormulaHeight keep_below_surface(double z, const WaveSurface& surface) {
    if (z <= 0.0 || z <= surface.elevation) return {z, Vec3::UnitZ()};
    return surface.elevation > 0.0 ? FormulaHeight{surface.elevation, surface.slope} : hold_at(0.0);
}

}  // namespace

FormulaHeight draw_to_still_water(double z, std::optional<double> depth, const WaveSurface& surface) {
    if (z >= surface.elevation) return hold_at(0.0);
    if (!depth) return {z - surface.elevation, Vec3::UnitZ() - surface.slope};
    if (z <= -*depth) return hold_at(-*depth);
    const double ratio = *depth / (*depth + surface.elevation);
    const double above_bed = ratio * (z + *depth);
    return {above_bed - *depth,
            ratio * Vec3::UnitZ() - above_bed / (*depth + surface.elevation) * surface.slope};
}

FormulaHeight find_formula_height(Stretching stretching,
                                  double z,
                                  std::optional<double> depth,
                                  const WaveSurface& surface) {
    if (stretching == Stretching::wheeler) return draw_to_still_water(z, depth, surface);
    if (depth && z <= -*depth) return hold_at(-*depth);
    if (stretching == Stretching::vertical) return z > 0.0 ? hold_at(0.0) : FormulaHeight{z, Vec3::UnitZ()};
    return keep_below_surface(z, surface);
}

}  // namespace gxrod
