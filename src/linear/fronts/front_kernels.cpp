#include "linear/fronts/front_kernels.hpp"

namespace gxrod {

FrontKernels find_front_kernels(InstructionSet set) {
    if (set == InstructionSet::avx512) return make_front_kernels_avx512();
    return set == InstructionSet::avx2 ? make_front_kernels_avx2() : make_front_kernels_baseline();
}

}  // namespace gxrod
