#pragma once

#include <optional>
#include <string>

#include "model/model.hpp"

namespace gxrod {

// How much stiffer a section is against turns of one direction than of another: the principal stiffnesses
// against twist and bending while no force acts. An offset of the section's axes does not change them.
struct StiffnessRatio {
    int rod = -1;         // of Model::rods
    double ratio = 1.0;   // the largest over the smallest
    int stiff_axis = -1;  // of twist and bending about y and z: which the stiffest direction is most like
    int soft_axis = -1;   // likewise
};

// The stiffness of twist and bending while no force acts, of a section's whole one: with C = [A B; Bᵀ D] it
// is D − Bᵀ A⁻¹ B. nullopt if nothing resists some force.
std::optional<Mat3> compute_turning_stiffness(const Mat6& stiffness);

// Of the rod that has the largest. nullopt without a rod all of whose stiffnesses are positive: what resists
// nothing is compared with nothing.
std::optional<StiffnessRatio> find_stiffness_ratio(const Model& model);

// "rod tape is 1e+04 times as stiff in bending about z as in bending about y".
std::string describe(const StiffnessRatio& ratio, const Model& model);

}  // namespace gxrod
