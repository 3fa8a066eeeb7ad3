#include "environment/wave_kernels.hpp"

#include "machine/built_sets.hpp"

namespace gxrod {

WaveKernels find_wave_kernels(InstructionSet set) {
    if constexpr (widest_built >= InstructionSet::avx2) {
        if (set >= InstructionSet::avx2) return make_wave_kernels_avx2();
    }
    if constexpr (is_built(InstructionSet::baseline)) {
        if (set == InstructionSet::baseline) return make_wave_kernels_baseline();
    }
    return {};
}

}  // namespace gxrod
