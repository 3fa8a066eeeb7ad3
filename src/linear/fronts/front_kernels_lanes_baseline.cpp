#include <xsimd/xsimd.hpp>

#include "linear/fronts/front_kernels.hpp"
#include "linear/fronts/make_front_kernels.hpp"

namespace gxrod {

FrontKernels make_front_kernels_baseline() { return FrontSweeps<xsimd::default_arch>::make(); }

}  // namespace gxrod
