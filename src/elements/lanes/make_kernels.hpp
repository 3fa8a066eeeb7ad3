#pragma once

#include "elements/lanes/kernels.hpp"
#include "elements/lanes/objective_lanes.hpp"
#include "elements/lanes/rotary_lanes.hpp"
#include "elements/lanes/two_node_lanes.hpp"

// Only for the sources of instruction sets; see lanes.hpp.
namespace gxrod {

template <class Arch>
Kernels make_kernels() {
    using Real = xsimd::batch<double, Arch>;
    static_assert(Real::size <= most_lanes);
    return {static_cast<int>(Real::size),
            {TwoNodeLanes<Real>::make_kernels(),
             ObjectiveLanes<3, Real>::make_kernels(),
             ObjectiveLanes<4, Real>::make_kernels(),
             ObjectiveLanes<5, Real>::make_kernels()},
            RotaryLanes<Real>::make_kernels(),
            RotaryLanes<Real>::make_damping_kernels()};
}

}  // namespace gxrod
