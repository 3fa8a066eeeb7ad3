#pragma once

#include <optional>

#include "assembly/system.hpp"
#include "state/state.hpp"

namespace gxrod {

// The system of small motions about an accepted state, and this state with the pairs that touch in it. Rods
// that touch each other are coupled in its pattern and its tangent, and contact has its forces at rest
// instead of impulses. If nothing can touch, both are the given ones.
class TouchingSystem {
  public:
    // Both must outlive it.
    TouchingSystem(const System& system, const State& state);

    const System& system() const { return own_system_ ? *own_system_ : *given_system_; }
    const State& state() const { return own_state_ ? *own_state_ : *given_state_; }

  private:
    const System* given_system_;
    const State* given_state_;
    std::optional<State> own_state_;
    std::optional<System> own_system_;
};

}  // namespace gxrod
