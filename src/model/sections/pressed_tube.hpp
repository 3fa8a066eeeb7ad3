#pragma once

#include <optional>

#include "model/model.hpp"

// Round tubes under the pressures of their contents and of water.
namespace gxrod {

struct Pressures {
    double inside = 0.0;
    double outside = 0.0;
};

// Computes the pressures on a section at a height z: they grow with the depth below the surface at rest, or
// below z = 0, by a gravity of this size. Outside there is pressure only below a surface.
Pressures compute_pressures(const SectionInFluid& section,
                            const std::optional<Water>& water,
                            double gravity,
                            double z);

// Recovers the pressures at a height from p_i A_i − p_o A_o there, whatever gravity was.
Pressures recover_pressures(const SectionInFluid& section,
                            const std::optional<Water>& water,
                            double pressure_force,
                            double z);

// A round tube about the section's origin.
struct PressedTube {
    double inner = 0.0, outer = 0.0;  // radii

    // Computes the stresses (xx yy zz yz xz xy) by pressures, at a place (y, z) of the section, in addition
    // to those of the resultants, of which the axial force is the effective tension: Lamé's, and the
    // pressures' part of the axial force on the wall (docs/theory/surroundings.md).
    Vec6 compute_stress(const Pressures& pressures, const Eigen::Vector2d& at) const;
};

// Whether pressures cannot be recovered, because contents weigh and the factor of the water changes.
bool has_unknown_pressures(const Model& model, const SectionInFluid& section);

// Returns the tube that a section is, if water or contents can press on it and it is hollow, of one material,
// which has no `strength`; nullopt if it is not, or if its contents weigh as much as the water that it
// displaces, or while the water's factor changes, so that the pressures cannot be recovered.
std::optional<PressedTube> find_pressed_tube(const Model& model, const Section& section);

}  // namespace gxrod
