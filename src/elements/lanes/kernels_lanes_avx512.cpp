#include "elements/lanes/kernels_of_sets.hpp"

#ifdef __AVX512F__
#include "elements/lanes/make_kernels.hpp"

namespace gxrod {

Kernels make_kernels_avx512() { return make_kernels<xsimd::avx512f>(); }

}  // namespace gxrod
#else
namespace gxrod {

Kernels make_kernels_avx512() { return make_kernels_avx2(); }

}  // namespace gxrod
#endif
