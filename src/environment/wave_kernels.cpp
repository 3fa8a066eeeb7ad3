#include "environment/wave_kernels.hpp"

namespace gxrod {

WaveKernels find_wave_kernels(InstructionSet set) {
    return set >= InstructionSet::avx2 ? make_wave_kernels_avx2() : make_wave_kernels_baseline();
}

}  // namespace gxrod
