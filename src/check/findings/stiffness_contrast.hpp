#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/parts.hpp"

namespace gxrod {

// A part in which round-off of the forces in one rod comes near the forces that bend another rod, or the same
// rod; or round-off of moments near the moments that do. Equilibrium, or a long time step, then takes
// Newton's method many iterations, or is not found.
struct StiffnessContrast {
    int stiff_rod = -1;      // index in Model::rods
    int soft_rod = -1;       // the same rod or another one
    double round_off = 0.0;  // round-off of the forces, or moments, in the stiff rod
    double bending = 0.0;    // a force, or moment, that bends the soft rod
    bool is_of_moments = false;
};

// Finds the contrast of each part that has one. Rods without bending stiffness, such as chains, do not count
// as soft.
std::vector<StiffnessContrast> find_stiffness_contrasts(const Model& model,
                                                        const std::vector<ModelPart>& parts);

// Finds the contrast of a part with one of these nodes, or of any part if there are none. Returns nullopt
// also if a rod of the part lacks a stiffness: it has no resistance at all, so round-off is not the cause.
std::optional<StiffnessContrast> find_contrast_at(const Model& model, std::span<const std::int64_t> nodes);

// Describes a contrast: "rod stiff is too stiff compared with what bends rod soft for numbers of 16 digits:
// round-off of its forces is about 8.9, a force that bends rod soft about 1".
std::string describe(const StiffnessContrast& contrast, const Model& model);

// Advises on a contrast: "EA, GAy and GAz up to 0.01 of what they are, or longer elements".
std::string advise(const StiffnessContrast& contrast);

}  // namespace gxrod
