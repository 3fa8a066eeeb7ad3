#pragma once

#include <cstdint>
#include <optional>

// Whether a series of equilibria follows one path: then strain energy changes by the work of the loads.
namespace gxrod {

// Between two load factors strain energy and work part by so much more than the uncertainty of the work.
struct EnergyJump {
    double from = 0.0;
    double to = 0.0;
    double energy = 0.0;
};

// Of a run; the largest of them.
struct EnergyJumps {
    std::int64_t count = 0;
    EnergyJump largest;
};

// What is looked at of an equilibrium: the ledger's row at its load factor.
struct EnergyPoint {
    double load_factor = 0.0;
    double strain_energy = 0.0;
    double external_work = 0.0;
    double work_uncertainty = 0.0;  // of the load step that led to it
};

// Of the largest energy of a run so far: smaller jumps are not reported.
inline constexpr double energy_worth_a_word = 0.01;

std::optional<EnergyJump> find_jump(const EnergyPoint& before,
                                    const EnergyPoint& after,
                                    double largest_energy);

void add_jump(const EnergyJump& jump, EnergyJumps& jumps);

}  // namespace gxrod
