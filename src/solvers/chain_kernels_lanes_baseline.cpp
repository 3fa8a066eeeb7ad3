#include <xsimd/xsimd.hpp>

#include "solvers/chain_kernels.hpp"
#include "solvers/make_chain_kernels.hpp"

namespace gxrod {

ChainKernels make_chain_kernels_baseline() { return ChainSweeps<xsimd::default_arch>::make(); }

}  // namespace gxrod
