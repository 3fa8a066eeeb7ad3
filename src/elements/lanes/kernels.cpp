#include "elements/lanes/kernels.hpp"

#include "elements/lanes/kernels_of_sets.hpp"
#include "machine/built_sets.hpp"

namespace gxrod {

Kernels find_kernels(InstructionSet set) {
    Kernels kernels;
    if constexpr (is_built(InstructionSet::avx512)) {
        if (set == InstructionSet::avx512) {
            kernels = make_kernels_avx512();
            add_general_kernels_avx512(kernels);
        }
    }
    if constexpr (is_built(InstructionSet::avx2)) {
        if (set == InstructionSet::avx2) {
            kernels = make_kernels_avx2();
            add_general_kernels_avx2(kernels);
        }
    }
    if constexpr (is_built(InstructionSet::baseline)) {
        if (set == InstructionSet::baseline) {
            kernels = make_kernels_baseline();
            add_general_kernels_baseline(kernels);
        }
    }
    return kernels;
}

}  // namespace gxrod
