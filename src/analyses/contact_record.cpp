#include "analyses/contact_record.hpp"

#include "assembly/contact/contact_assembly.hpp"

namespace gxrod {

void ContactRecord::show_in(Snapshot& snapshot) const {
    snapshot.obstacles = obstacles;
    snapshot.watched_contacts = watched;
    snapshot.touches = touches;
    snapshot.contact_forces = forces;
    snapshot.contact_gaps = gaps;
}

ContactRecord record_contacts(const System& system,
                              const State& state,
                              double time,
                              const std::vector<ContactWatch>& watched,
                              bool is_for_frame) {
    ContactRecord record;
    const ContactAssembly* contact = system.contact();
    if (!contact) return record;
    record.obstacles = contact->compute_obstacle_values(state, time);
    if (is_for_frame || !watched.empty()) record.touches = contact->list_touches(state, time);
    for (const ContactWatch& one : watched)
        record.watched.push_back(contact->compute_watched(one, record.touches, state, time));
    if (!is_for_frame) return record;
    record.forces = contact->compute_forces(state, time);
    record.gaps = contact->compute_gaps(state, time);
    return record;
}

}  // namespace gxrod
