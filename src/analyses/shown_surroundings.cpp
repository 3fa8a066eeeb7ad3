#include "analyses/shown_surroundings.hpp"

#include "assembly/system_values.hpp"

namespace gxrod {

void show_surroundings(
    const System& system, const State& state, double time, bool is_for_frame, Snapshot& snapshot) {
    const std::optional<Seabed>& seabed = system.model().surroundings.seabed;
    snapshot.has_ground = !seabed || seabed->acts();
    if (!is_for_frame) return;
    const SystemValues values(system);
    snapshot.pressure_forces = values.compute_pressure_forces(state, time);
    snapshot.bed_forces = values.compute_bed_forces(state, time);
}

}  // namespace gxrod
