#pragma once

#include "machine/instruction_set.hpp"

// The instruction sets for which this build has kernels: all, or the one of the machine that built it
// (GXROD_INSTRUCTION_SETS). CMake defines both ends for the library's sources.
namespace gxrod {

constexpr InstructionSet narrowest_built = InstructionSet::GXROD_NARROWEST_SET;
constexpr InstructionSet widest_built = InstructionSet::GXROD_WIDEST_SET;

constexpr bool is_built(InstructionSet set) { return narrowest_built <= set && set <= widest_built; }

}  // namespace gxrod
