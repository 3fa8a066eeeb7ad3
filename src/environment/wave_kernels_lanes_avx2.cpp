#include "environment/wave_kernels.hpp"

#include "environment/make_wave_kernels.hpp"

namespace gxrod {

WaveKernels make_wave_kernels_avx2() { return WaveLanes<xsimd::avx2>::make(); }

}  // namespace gxrod
