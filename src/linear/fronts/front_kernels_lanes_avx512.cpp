#include "linear/fronts/front_kernels.hpp"

#include <xsimd/xsimd.hpp>

#include "linear/fronts/make_front_kernels.hpp"

namespace gxrod {

FrontKernels make_front_kernels_avx512() { return FrontSweeps<xsimd::avx512f>::make(); }

}  // namespace gxrod
