#pragma once

#include "elements/lanes/kernels.hpp"

// The kernels by instruction set, each compiled for it.
namespace gxrod {

Kernels make_kernels_baseline();
// Those of the baseline where the compiler has no such set.
Kernels make_kernels_avx2();

}  // namespace gxrod
