#pragma once

#include "elements/lanes/kernels.hpp"

// The kernels by instruction set, each compiled for it. General sections have separate sources: in one source
// the compiler would inline less into the kernels for plain sections.
namespace gxrod {

Kernels make_kernels_baseline();
void add_general_kernels_baseline(Kernels& kernels);
Kernels make_kernels_avx2();
void add_general_kernels_avx2(Kernels& kernels);
Kernels make_kernels_avx512();
void add_general_kernels_avx512(Kernels& kernels);

}  // namespace gxrod
