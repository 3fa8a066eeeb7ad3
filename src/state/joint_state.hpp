#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace gxrod {

// The variables of a joint that evolve in time.
struct JointState {
    std::array<double, 6> multipliers{};  // per equation: forces and moments that A exerts on B
    double turn = 0.0;                    // turn of B against A about the axis, whole turns included
    double slide = 0.0;                   // slide; for a sleeve along its rod, from its place at t = 0
};

// The values of turn and slide at which their friction is zero.
struct JointSlips {
    double turn = 0.0;
    double slide = 0.0;
};

// Whether a joint holds.
enum class JointHold {
    holds,
    rests,       // does not act in this stage
    has_broken,  // in this stage
    is_broken    // from before
};

// The numbers of a joint in State::memory: its slips, its hold, and the time at which it broke.
inline constexpr std::size_t numbers_of_joint = 4;
inline JointHold read_hold(std::span<const double> memory) { return static_cast<JointHold>(memory[2]); }
inline void write(JointHold hold, double time, std::span<double> memory) {
    memory[2] = static_cast<double>(hold);
    memory[3] = time;
}
inline JointSlips read_slips(std::span<const double> memory) { return {memory[0], memory[1]}; }
inline void write(const JointSlips& slips, std::span<double> memory) {
    memory[0] = slips.turn;
    memory[1] = slips.slide;
}

}  // namespace gxrod
