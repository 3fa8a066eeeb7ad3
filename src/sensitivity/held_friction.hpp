#pragma once

#include <array>
#include <vector>

#include "assembly/system.hpp"

namespace gxrod {

// Friction of joints and tendons exerts a force that does not depend, while it slips, on where it began to.
// So what it remembers can be moved by as much as it sticks at most: then it slips next to a state, too, at
// whose limit it is, and is smooth there.
class HeldFriction {
  public:
    // Of the trial motions at `time`. What is at its limit to rounding slips.
    HeldFriction(const System& system, const State& state, double time);
    // Moves what the friction that slips remembers, of this state or of one next to it.
    void move(State& state) const;

  private:
    struct Slip {
        std::size_t joint;
        double turn = 0.0, slide = 0.0;
    };
    void find_slips(const System& system, const State& state, double time);
    void find_tensions(const System& system, const State& state, double time);

    std::vector<Slip> slips_;
    std::vector<double> tensions_;  // of the last entries of State::law_memory
};

}  // namespace gxrod
