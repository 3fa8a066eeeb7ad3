#pragma once

#include <vector>

#include "assembly/system.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// The contact values that snapshots show; empty without contact.
struct ContactRecord {
    std::vector<ObstacleValues> obstacles, watched;
    std::vector<ContactTouch> touches;
    std::vector<Vec6> forces;
    std::vector<double> gaps;

    void show_in(Snapshot& snapshot) const;
};

// Records the contact of an accepted state at this time; touches, forces and gaps only for a frame.
ContactRecord record_contacts(const System& system,
                              const State& state,
                              double time,
                              const std::vector<ContactWatch>& watched,
                              bool is_for_frame);

}  // namespace gxrod
