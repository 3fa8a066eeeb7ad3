#pragma once

#include "assembly/system.hpp"
#include "model/settings/settings.hpp"
#include "state/records/mode_record.hpp"

namespace gxrod {

// Finds the factors λ of additional load at which an equilibrium becomes unstable, by the resultants that the
// load adds in the linear solution: (K₀ + λ K_σ) φ = 0 (docs/theory/vibrations.md). The equilibrium is an
// accepted state with loads at its time; λ multiplies all loads of the model, gravity included, at
// `load_time`, in addition to the present loads. Supports do not move.
BucklingRecord find_buckling(const System& system,
                             const State& state,
                             double load_time,
                             const BucklingSettings& settings);

}  // namespace gxrod
