#pragma once

#include <optional>
#include <string>

#include "model/model.hpp"

namespace gxrod {

// The ratio of a section's largest and smallest stiffness against turns: the principal stiffnesses against
// twist and bending without force. An offset of the section's axes does not change them.
struct StiffnessRatio {
    int rod = -1;         // index in Model::rods
    double ratio = 1.0;   // the largest over the smallest
    int stiff_axis = -1;  // twist or bending about y or z, whichever is nearest to the stiffest direction
    int soft_axis = -1;   // the same for the softest direction
};

// Computes the stiffness against twist and bending without force from a section's full stiffness: with C = [A
// B; Bᵀ D] it is D − Bᵀ A⁻¹ B. Returns nullopt if some force meets no resistance.
std::optional<Mat3> compute_turning_stiffness(const Mat6& stiffness);

// Finds the rod with the largest ratio. Returns nullopt without a rod whose stiffnesses are all positive: a
// vanishing stiffness is not compared.
std::optional<StiffnessRatio> find_stiffness_ratio(const Model& model);

// Describes a ratio: "rod tape is 1e+04 times as stiff in bending about z as in bending about y".
std::string describe(const StiffnessRatio& ratio, const Model& model);

}  // namespace gxrod
