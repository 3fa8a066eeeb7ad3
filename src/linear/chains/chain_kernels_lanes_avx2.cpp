#include "linear/chains/chain_kernels.hpp"

#ifdef __AVX2__
#include <xsimd/xsimd.hpp>

#include "linear/chains/make_chain_kernels.hpp"

namespace gxrod {

ChainKernels make_chain_kernels_avx2() { return ChainSweeps<xsimd::avx2>::make(); }

}  // namespace gxrod
#else
namespace gxrod {

ChainKernels make_chain_kernels_avx2() { return make_chain_kernels_baseline(); }

}  // namespace gxrod
#endif
