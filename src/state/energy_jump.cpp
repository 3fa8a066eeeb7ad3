#include "state/energy_jump.hpp"

#include <cmath>

namespace gxrod {

std::optional<EnergyJump> find_jump(const EnergyPoint& before,
                                    const EnergyPoint& after,
                                    double largest_energy) {
    const double imbalance =
        (after.strain_energy - before.strain_energy) - (after.external_work - before.external_work);
    const double unexplained = std::abs(imbalance) - after.work_uncertainty;
    if (!(unexplained > energy_worth_a_word * largest_energy)) return std::nullopt;
    return EnergyJump{before.load_factor, after.load_factor, unexplained};
}

void add_jump(const EnergyJump& jump, EnergyJumps& jumps) {
    ++jumps.count;
    if (jump.energy > jumps.largest.energy) jumps.largest = jump;
}

}  // namespace gxrod
