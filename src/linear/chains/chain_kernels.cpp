#include "linear/chains/chain_kernels.hpp"

namespace gxrod {

ChainKernels find_chain_kernels(InstructionSet set) {
    if (set == InstructionSet::avx512) return make_chain_kernels_avx512();
    return set == InstructionSet::avx2 ? make_chain_kernels_avx2() : make_chain_kernels_baseline();
}

}  // namespace gxrod
