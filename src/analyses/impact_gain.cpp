#include "analyses/impact_gain.hpp"

namespace gxrod {

bool gains_by_contact(const System& system,
                      const Ledger& ledger,
                      const State& state,
                      const Ledger::Step& step,
                      bool is_shortened) {
    constexpr double tolerable = 1e-4;
    State start = state;
    undo_trial(start);
    State end = state;
    Ledger books = ledger;
    books.add_step(state, step);
    system.commit(end, step.time);
    const LedgerRow before = ledger.row(start), after = books.row(end);
    if (!is_shortened && before.contact_energy == 0.0 && after.contact_energy == 0.0) return false;
    const double scale = std::max(before.kinetic_energy + before.strain_energy + before.contact_energy,
                                  after.kinetic_energy + after.strain_energy + after.contact_energy);
    return after.energy_error - before.energy_error > tolerable * scale;
}

}  // namespace gxrod
