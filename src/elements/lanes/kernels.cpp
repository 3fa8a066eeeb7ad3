#include "elements/lanes/kernels.hpp"

#include "elements/lanes/kernels_of_sets.hpp"

namespace gxrod {

Kernels find_kernels(InstructionSet set) {
    return set == InstructionSet::avx2 ? make_kernels_avx2() : make_kernels_baseline();
}

}  // namespace gxrod
