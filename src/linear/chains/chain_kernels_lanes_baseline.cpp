#include <xsimd/xsimd.hpp>

#include "linear/chains/chain_kernels.hpp"
#include "linear/chains/make_chain_kernels.hpp"

namespace gxrod {

ChainKernels make_chain_kernels_baseline() { return ChainSweeps<xsimd::default_arch>::make(); }

}  // namespace gxrod
