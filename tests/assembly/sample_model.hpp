#pragma once

#include "assembly/system.hpp"
#include "tools/random_values.hpp"

// A small model with everything in it, in random finite motion: a rod of three elements on a ball joint, a
// body with offset on its end, a second body on a hinge of its own, loads of every frame, gravity.
namespace gxrod::tools {

constexpr int rod_end = 3;
constexpr int lone_node = 4;
Model make_sample_model();

// A model in which everything is turned: a curved rod of two elements, damped both ways, its centre of mass
// off its line; at its start a hinge with axes of its own that also moves, at its end a roller on a slope;
// nodal and distributed loads of every frame.
Model make_turned_model(ElementKind kind, int order);

// Finite rotations and displacements of a step, curved histories; rates as the integrator makes them are for
// the caller to set.
State make_sample_state(const System& system, unsigned seed);
// Nodes of one element less turned against each other than all together.
State make_turned_state(const System& system, unsigned seed);

// The matrix that values on a pattern stand for.
}  // namespace gxrod::tools
