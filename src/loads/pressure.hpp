#pragma once

#include <optional>

#include "model/surroundings.hpp"

namespace gxrod {

// Computes p_i A_i − p_o A_o of a section at a height z: pressures grow with the depth below the surface at
// rest, or below z = 0, by a gravity of this size. Outside there is pressure only below a surface, times
// `water_factor`. A wall carries the effective tension plus this force (docs/theory/surroundings.md).
double compute_pressure_force(const SectionInFluid& section,
                              const std::optional<Water>& water,
                              double gravity,
                              double z,
                              double water_factor = 1.0);

// Computes the strain of the wall by these pressures: (1 − 2ν)(p_i A_i − p_o A_o)/EA.
inline double compute_pressure_strain(const SectionInFluid& section, double pressure_force, double EA) {
    return (1.0 - 2.0 * section.poisson) * pressure_force / EA;
}

}  // namespace gxrod
