#pragma once

#include "elements/lanes/kernels.hpp"

// The kernels by instruction set, each compiled for it. Those for general sections come from sources of their
// own: next to them the compiler would inline less into those for plain ones.
namespace gxrod {

Kernels make_kernels_baseline();
void add_general_kernels_baseline(Kernels& kernels);
// Where the compiler has no such set, those of the next narrower one.
Kernels make_kernels_avx2();
void add_general_kernels_avx2(Kernels& kernels);
Kernels make_kernels_avx512();
void add_general_kernels_avx512(Kernels& kernels);

}  // namespace gxrod
