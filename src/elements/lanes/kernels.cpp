#include "elements/lanes/kernels.hpp"

#include "elements/lanes/kernels_of_sets.hpp"

namespace gxrod {

Kernels find_kernels(InstructionSet set) {
    switch (set) {
        case InstructionSet::avx512: {
            Kernels kernels = make_kernels_avx512();
            add_general_kernels_avx512(kernels);
            return kernels;
        }
        case InstructionSet::avx2: {
            Kernels kernels = make_kernels_avx2();
            add_general_kernels_avx2(kernels);
            return kernels;
        }
        case InstructionSet::baseline:
            break;
    }
    Kernels kernels = make_kernels_baseline();
    add_general_kernels_baseline(kernels);
    return kernels;
}

}  // namespace gxrod
