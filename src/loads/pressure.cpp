#include "loads/pressure.hpp"

#include "model/sections/pressed_tube.hpp"

namespace gxrod {

double compute_pressure_force(const SectionInFluid& section,
                              const std::optional<Water>& water,
                              double gravity,
                              double z,
                              double water_factor) {
    const Pressures pressures = compute_pressures(section, water, gravity, z);
    return pressures.inside * section.contents_area - water_factor * pressures.outside * section.area;
}

}  // namespace gxrod
