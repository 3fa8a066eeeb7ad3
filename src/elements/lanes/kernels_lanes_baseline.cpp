#include "elements/lanes/kernels_of_sets.hpp"
#include "elements/lanes/make_kernels.hpp"

namespace gxrod {

Kernels make_kernels_baseline() { return make_kernels<xsimd::default_arch>(); }

}  // namespace gxrod
