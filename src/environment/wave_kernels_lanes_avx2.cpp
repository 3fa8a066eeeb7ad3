#include "environment/wave_kernels.hpp"

#ifdef __AVX2__
#include "environment/make_wave_kernels.hpp"

namespace gxrod {

WaveKernels make_wave_kernels_avx2() { return WaveLanes<xsimd::avx2>::make(); }

}  // namespace gxrod
#else
namespace gxrod {

WaveKernels make_wave_kernels_avx2() { return make_wave_kernels_baseline(); }

}  // namespace gxrod
#endif
