#include "elements/lanes/kernels_of_sets.hpp"

#include "elements/lanes/make_kernels.hpp"

namespace gxrod {

Kernels make_kernels_avx512() { return make_kernels<xsimd::avx512f>(); }

}  // namespace gxrod
