#pragma once

#include "assembly/system.hpp"
#include "model/settings/settings.hpp"
#include "state/records/mode_record.hpp"

namespace gxrod {

// The factors λ at which more load makes an equilibrium give way, by the resultants that the load adds in the
// linear solution: (K₀ + λ K_σ) φ = 0 (docs/theory/vibrations.md). The equilibrium is an accepted state with
// loads at its time; λ multiplies all loads of the model, gravity included, at `load_time`, in addition to
// what acts. Supports do not move.
BucklingRecord find_buckling(const System& system,
                             const State& state,
                             double load_time,
                             const BucklingSettings& settings);

}  // namespace gxrod
