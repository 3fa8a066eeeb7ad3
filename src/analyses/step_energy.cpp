#include "analyses/step_energy.hpp"

#include <cmath>

#include "solvers/energy_limit.hpp"

namespace gxrod {

std::optional<Ledger> conserve_energy(const TriedStep& step,
                                      const StepStart& start,
                                      EquilibriumReport& report) {
    constexpr int most_passes = 4;
    constexpr double round_off = 1e-14;
    for (int pass = 0; pass < most_passes; ++pass) {
        Ledger after = step.ledger;
        after.add_step(step.state, step.books());
        const LedgerRow end = after.row(step.state);
        const double surplus = end.energy_error - start.energy_error;
        const double size = end.kinetic_energy + std::abs(end.strain_energy) + std::abs(end.external_work);
        if (pass > 0 && std::abs(surplus) <= round_off * size) return after;
        conserve(step.system, start, step.stage, surplus, step.state, report);
        if (!report.converged()) break;
    }
    return std::nullopt;
}

std::optional<Ledger> limit_energy(const TriedStep& step, int cuts, EquilibriumReport& report) {
    constexpr int most_cuts = 5;
    Ledger after = step.ledger;
    after.add_step(step.state, step.books());
    const double surplus = after.surplus();
    if (surplus == 0.0) return after;
    const bool touches = report.shortened > 0 || step.ledger.touches() || after.touches();
    const bool is_cut_first = touches && step.integrator.resolves_contact() && cuts < most_cuts;
    if (!is_cut_first && take_surplus(step.system, step.stage, surplus, step.workspace, step.state) > 0.0)
        return std::nullopt;
    report.outcome = Outcome::energy_out_of_reach;
    report.worst_node = report.worst_component = -1;
    return std::nullopt;
}

}  // namespace gxrod
