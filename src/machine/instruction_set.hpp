#pragma once

namespace gxrod {

// Instructions that kernels for several elements at once use. All give the same bits.
enum class InstructionSet {
    baseline,  // every processor of this kind has it: two lanes
    avx2,      // four lanes
    avx512,    // eight lanes: AVX-512 F, CD, DQ and VL, and FMA, which headers ask for
};

// Returns the widest set that this machine has and for which gxrod was built, or the one that the environment
// variable GXROD_INSTRUCTION_SET names: "baseline", "avx2" or "avx512". Throws std::invalid_argument for
// another word or a set that the machine or this build lacks, and std::runtime_error if the machine has none
// of those built.
InstructionSet find_instruction_set();

}  // namespace gxrod
