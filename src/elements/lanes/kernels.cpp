#include "elements/lanes/kernels.hpp"

#include "elements/lanes/kernels_of_sets.hpp"

namespace gxrod {

Kernels find_kernels(InstructionSet set) {
    const bool is_wide = set == InstructionSet::avx2;
    Kernels kernels = is_wide ? make_kernels_avx2() : make_kernels_baseline();
    is_wide ? add_general_kernels_avx2(kernels) : add_general_kernels_baseline(kernels);
    return kernels;
}

}  // namespace gxrod
