#pragma once

#include <vector>

#include "assembly/system.hpp"

namespace gxrod {

// While friction of joints and tendons slips, its force does not depend on where slipping began. So its
// memory can be moved by as much as it sticks at most. Friction exactly at its limit then slips in
// neighbouring states, too, and is smooth there.
class HeldFriction {
  public:
    // Takes the trial motions at `time`. Friction slips if it is at its limit to rounding.
    HeldFriction(const System& system, const State& state, double time);
    // Moves the memory of the friction that slips, in this state or in one next to it.
    void move(State& state) const;

  private:
    // Adds to moves_ at the numbers of these parts.
    void find_slips(const System& system, const State& state, double time);
    void find_tensions(const System& system, const State& state, double time);

    std::vector<double> moves_;  // for State::memory
};

}  // namespace gxrod
