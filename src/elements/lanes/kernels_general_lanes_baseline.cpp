#include "elements/lanes/kernels_of_sets.hpp"
#include "elements/lanes/make_general_kernels.hpp"

namespace gxrod {

void add_general_kernels_baseline(Kernels& kernels) { add_general_kernels<xsimd::default_arch>(kernels); }

}  // namespace gxrod
