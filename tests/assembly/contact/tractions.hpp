#pragma once

#include "assembly/contact/contact_assembly.hpp"
#include "assembly/system.hpp"
#include "state/state.hpp"

namespace gxrod {

// Sets what friction from obstacles remembers to choose(place).
template <class Choose>
void set_tractions(const System& system, State& state, const Choose& choose) {
    const MemorySlice memory = contact_assembly_of(system)->memory();
    for (std::size_t i = 0; 3 * i < memory.count; ++i)
        Eigen::Map<Vec3>(memory.piece(i, 3).of(state).data()) = choose(i);
}

}  // namespace gxrod
