#pragma once

#include <array>
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
    struct Slip {
        std::size_t joint;
        double turn = 0.0, slide = 0.0;
    };
    void find_slips(const System& system, const State& state, double time);
    void find_tensions(const System& system, const State& state, double time);

    std::vector<Slip> slips_;
    std::vector<double> tensions_;  // for the last entries of State::law_memory
};

}  // namespace gxrod
