#include "loads/pressure.hpp"

namespace gxrod {

double compute_pressure_force(const SectionInFluid& section,
                              const std::optional<Water>& water,
                              double gravity,
                              double z) {
    const double depth = (water ? water->surface.value_or(0.0) : 0.0) - z;
    const double inside = section.contents_pressure + section.contents_density * gravity * depth;
    const bool is_wet = water && water->surface && depth > 0.0;
    const double outside = is_wet ? water->density * gravity * depth : 0.0;
    return inside * section.contents_area - outside * section.area;
}

}  // namespace gxrod
