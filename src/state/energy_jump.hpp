#pragma once

#include <cstdint>
#include <optional>

// Checks whether a series of equilibria follows one path: if so, strain energy changes by the work of the
// loads.
namespace gxrod {

// An energy by which, between two load factors, the change of strain energy differs from the work, beyond the
// uncertainty of the work.
struct EnergyJump {
    double from = 0.0;
    double to = 0.0;
    double energy = 0.0;
};

// The jumps of a run, and the largest of them.
struct EnergyJumps {
    std::int64_t count = 0;
    EnergyJump largest;
};

// Energies of an equilibrium, from the ledger's row at its load factor.
struct EnergyPoint {
    double load_factor = 0.0;
    double strain_energy = 0.0;
    double external_work = 0.0;
    double work_uncertainty = 0.0;  // uncertainty of the load step that led to it
};

// Share of the largest energy of a run so far; smaller jumps are not reported.
inline constexpr double energy_worth_a_word = 0.01;

std::optional<EnergyJump> find_jump(const EnergyPoint& before,
                                    const EnergyPoint& after,
                                    double largest_energy);

void add_jump(const EnergyJump& jump, EnergyJumps& jumps);

}  // namespace gxrod
