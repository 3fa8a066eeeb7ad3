#include "linear/chains/chain_kernels.hpp"

#include "machine/built_sets.hpp"

namespace gxrod {

ChainKernels find_chain_kernels(InstructionSet set) {
    if constexpr (is_built(InstructionSet::avx512)) {
        if (set == InstructionSet::avx512) return make_chain_kernels_avx512();
    }
    if constexpr (is_built(InstructionSet::avx2)) {
        if (set == InstructionSet::avx2) return make_chain_kernels_avx2();
    }
    if constexpr (is_built(InstructionSet::baseline)) {
        if (set == InstructionSet::baseline) return make_chain_kernels_baseline();
    }
    return {};
}

}  // namespace gxrod
