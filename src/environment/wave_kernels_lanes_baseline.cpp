#include "environment/make_wave_kernels.hpp"
#include "environment/wave_kernels.hpp"

namespace gxrod {

WaveKernels make_wave_kernels_baseline() { return WaveLanes<xsimd::default_arch>::make(); }

}  // namespace gxrod
