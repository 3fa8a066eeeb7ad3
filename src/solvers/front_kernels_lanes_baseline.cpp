#include <xsimd/xsimd.hpp>

#include "solvers/front_kernels.hpp"
#include "solvers/make_front_kernels.hpp"

namespace gxrod {

FrontKernels make_front_kernels_baseline() { return FrontSweeps<xsimd::default_arch>::make(); }

}  // namespace gxrod
