#include "elements/lanes/kernels_of_sets.hpp"

#include "elements/lanes/make_general_kernels.hpp"

namespace gxrod {

void add_general_kernels_avx2(Kernels& kernels) { add_general_kernels<xsimd::avx2>(kernels); }

}  // namespace gxrod
