#include "linear/chains/chain_kernels.hpp"

#include <xsimd/xsimd.hpp>

#include "linear/chains/make_chain_kernels.hpp"

namespace gxrod {

ChainKernels make_chain_kernels_avx512() { return ChainSweeps<xsimd::avx512f>::make(); }

}  // namespace gxrod
