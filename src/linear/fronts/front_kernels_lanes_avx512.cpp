#include "linear/fronts/front_kernels.hpp"

#ifdef __AVX512DQ__
#include <xsimd/xsimd.hpp>

#include "linear/fronts/make_front_kernels.hpp"

namespace gxrod {

FrontKernels make_front_kernels_avx512() { return FrontSweeps<xsimd::avx512f>::make(); }

}  // namespace gxrod
#else
namespace gxrod {

FrontKernels make_front_kernels_avx512() { return make_front_kernels_avx2(); }

}  // namespace gxrod
#endif
