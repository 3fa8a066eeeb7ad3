#pragma once

#include "elements/lanes/general_objective_lanes.hpp"
#include "elements/lanes/general_two_node_lanes.hpp"

// Only for the sources of instruction sets; see lanes.hpp.
namespace gxrod {

template <class Arch>
void add_general_kernels(Kernels& kernels) {
    using Real = xsimd::batch<double, Arch>;
    GeneralTwoNodeLanes<Real>::add_kernels(std::get<RodKernels<2>>(kernels.rods));
    GeneralObjectiveLanes<3, Real>::add_kernels(std::get<RodKernels<3>>(kernels.rods));
    GeneralObjectiveLanes<4, Real>::add_kernels(std::get<RodKernels<4>>(kernels.rods));
    GeneralObjectiveLanes<5, Real>::add_kernels(std::get<RodKernels<5>>(kernels.rods));
}

}  // namespace gxrod
