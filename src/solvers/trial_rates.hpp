#pragma once

#include "assembly/system.hpp"
#include "integrators/integrator.hpp"

namespace gxrod {

// Sets velocities and accelerations of a stage's trial motions: the integrator's from r, Λ and θ, and for
// held components the values that supports prescribe. From a prescribed r the integrator's own update would
// give accelerations that ring undamped (Newmark), grow (β < ¼) or stay far from f″ (several stages).
void update_trial_rates(const System& system, const Integrator& integrator, const Stage& stage, State& state);

}  // namespace gxrod
