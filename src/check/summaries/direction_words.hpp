#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assembly/system.hpp"

namespace gxrod {

// What a model resists least, in a user's words.
struct Weakness {
    // "rod cable, node 14: twist", "the whole model moves along x or y, or turns about z", "rod shaft turns
    // about its own axis".
    std::string words;
    // Against the stiffest unknown, lengths over the model's length: about 1e-16 if the tangent is singular.
    double stiffness = 0.0;
};

// The direction for which a tangent is smallest, at the trial motions of the state, whose values are on
// this pattern; nullopt if they are not finite or nothing can move. Costs a few factorizations: for
// failures only.
std::optional<Weakness> describe_weakness(const System& system,
                                          const State& state,
                                          const SparsePattern& pattern,
                                          const std::vector<double>& values);

// What a direction, per node (δr over the model's length, δφ), is as a motion in one piece of the part that
// moves most, "the whole model moves along x"; "" if it strains that part.
std::string describe_rigid_direction(const System& system,
                                     const State& state,
                                     const std::vector<Vec6>& direction);

// Whether a tangent this weak in one direction has an inverse in name only.
inline constexpr double singular_stiffness = 1e-15;

}  // namespace gxrod
