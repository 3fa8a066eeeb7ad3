#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assembly/system.hpp"

namespace gxrod {

// The direction of least stiffness of a model, in a user's words.
struct Weakness {
    // For example "rod cable, node 14: twist", "the whole model moves along x or y, or turns about z", "rod
    // shaft turns about its own axis".
    std::string words;
    // The stiffness relative to the stiffest unknown, lengths over the model's length: about 1e-16 if the
    // tangent is singular.
    double stiffness = 0.0;
};

// Describes the weakest direction of a tangent, whose values are on this pattern, at the trial motions of the
// state; nullopt if the values are not finite or nothing can move. Costs a few factorizations: for failures
// only.
std::optional<Weakness> describe_weakness(const System& system,
                                          const State& state,
                                          const SparsePattern& pattern,
                                          const std::vector<double>& values);

// Describes a direction, per node (δr over the model's length, δφ), as a rigid motion of the part that moves
// most, "the whole model moves along x"; "" if it strains that part.
std::string describe_rigid_direction(const System& system,
                                     const State& state,
                                     const std::vector<Vec6>& direction);

// Below this stiffness in one direction a tangent is singular in practice.
inline constexpr double singular_stiffness = 1e-15;

}  // namespace gxrod
