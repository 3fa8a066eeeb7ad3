#pragma once

#include <string>

#include "check/motions/rigid_motion.hpp"
#include "check/scaled_tangent.hpp"

namespace gxrod {

// Describes displacements along and rotations about the global axes that neither supports nor the tangent
// resist: "moves along x or y, or turns about z"; "" if there are none. Rotations are about the part's held
// nodes, or its centre if none is held.
std::string describe_free_motions(const ModelPart& part,
                                  const ScaledTangent& tangent,
                                  const System& system,
                                  const State& state);

// Describes a motion: "moves along x", "turns about z through arm.start", "turns about its own axis".
std::string describe_rigid_motion(const RigidMotion& motion,
                                  const ModelPart& part,
                                  const System& system,
                                  const State& state);

}  // namespace gxrod
