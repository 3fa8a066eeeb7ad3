#pragma once

#include "deck/problem.hpp"

namespace gxrod::speed {

// A clamped rubber rod of 1 m that falls from the horizontal, Δt = 1 ms; `steps` of them.
Problem make_pendulum(int elements, int order, long steps);

}  // namespace gxrod::speed
