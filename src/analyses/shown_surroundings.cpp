#include "analyses/shown_surroundings.hpp"

#include "assembly/system_values.hpp"

namespace gxrod {

void show_surroundings(const System& system, const State& state, double time, Snapshot& snapshot) {
    const SystemValues values(system);
    snapshot.pressure_forces = values.compute_pressure_forces(state, time);
    snapshot.bed_forces = values.compute_bed_forces(state);
}

}  // namespace gxrod
