#pragma once

#include "deck/problem.hpp"

// What is run to measure times.
namespace gxrod::speed {

// pendulum.toml: a clamped rubber rod of 1 m that falls from the horizontal, Δt = 1 ms; `steps` of them.
Problem make_pendulum(int elements, int order, long steps, ElementKind kind = ElementKind::objective);

// roll_up.toml: that rod, rolled into a full circle by an end couple in `steps` steps.
Problem make_roll_up(int elements, int order, int steps);

// A square net of `rods` rods each way, 0.1 m apart, rigidly joined where they cross, `elements` of order 1
// between two crossings; clamped along its edge, it falls as the pendulum does.
Problem make_net(int rods, int elements, long steps);

}  // namespace gxrod::speed
