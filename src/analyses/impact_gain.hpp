#pragma once

#include "analyses/ledger.hpp"

namespace gxrod {

// Whether a step that is solved and not committed raises the energy, though contact acts at its stages: they
// did not resolve an impact. `is_shortened`: contact has shortened an increment, even if nothing touches at
// both ends of the step.
bool gains_by_contact(const System& system,
                      const Ledger& ledger,
                      const State& state,
                      const Ledger::Step& step,
                      bool is_shortened);

}  // namespace gxrod
