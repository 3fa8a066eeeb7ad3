#pragma once

#include "assembly/system.hpp"
#include "integrators/integrator.hpp"

namespace gxrod {

// Velocities and accelerations of a stage's trial motions: what the integrator makes of r, Λ and θ and, of
// held components, those that the supports prescribe. From a prescribed r the integrator's own update would
// find accelerations that ring undamped (Newmark), grow (β < ¼) or stay far from those of f (several stages).
void update_trial_rates(const System& system, const Integrator& integrator, const Stage& stage, State& state);

}  // namespace gxrod
