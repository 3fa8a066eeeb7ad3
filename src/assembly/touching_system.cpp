#include "assembly/touching_system.hpp"

#include "assembly/contact/contacts.hpp"

namespace gxrod {

TouchingSystem::TouchingSystem(const System& system, const State& state)
    : given_system_(&system), given_state_(&state) {
    const Contacts contacts(system);
    if (!contacts.are_possible() || touching_groups_of(system)) return;
    State& own = own_state_.emplace(state);
    undo_trial(own);
    contacts.search(own);
    own_system_.emplace(system.model(), system.team(), contacts.list_groups(own));
}

}  // namespace gxrod
