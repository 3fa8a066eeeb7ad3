#include "linear/fronts/front_kernels.hpp"

#include <xsimd/xsimd.hpp>

#include "linear/fronts/make_front_kernels.hpp"

namespace gxrod {

FrontKernels make_front_kernels_avx2() { return FrontSweeps<xsimd::avx2>::make(); }

}  // namespace gxrod
