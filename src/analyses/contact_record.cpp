#include "analyses/contact_record.hpp"

#include "assembly/contact/contacts.hpp"

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
    const Contacts contacts(system);
    if (!contacts.are_possible()) return record;
    record.obstacles = contacts.compute_obstacle_values(state, time);
    if (is_for_frame || !watched.empty()) record.touches = contacts.list_touches(state, time);
    for (const ContactWatch& one : watched)
        record.watched.push_back(contacts.compute_watched(one, record.touches, state, time));
    if (!is_for_frame) return record;
    record.forces = contacts.compute_forces(state, time);
    record.gaps = contacts.compute_gaps(state, time);
    return record;
}

}  // namespace gxrod
