#pragma once

namespace gxrod {

// What of the processor kernels use that work on several elements at once. All give the same bits.
enum class InstructionSet {
    baseline,  // what every processor of this kind has: two lanes
    avx2,      // four lanes
    avx512,    // eight lanes: AVX-512 F, CD, DQ and VL, and FMA, which headers ask for
};

// The widest that this machine has. The environment variable GXROD_INSTRUCTION_SET, "baseline", "avx2" or
// "avx512", chooses another; throws std::invalid_argument if it says something else or what the machine
// lacks.
InstructionSet find_instruction_set();

}  // namespace gxrod
