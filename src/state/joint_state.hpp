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

// As numbers in State::memory.
inline constexpr std::size_t numbers_of_slips = 2;
inline JointSlips read_slips(std::span<const double> memory) { return {memory[0], memory[1]}; }
inline void write(const JointSlips& slips, std::span<double> memory) {
    memory[0] = slips.turn;
    memory[1] = slips.slide;
}

}  // namespace gxrod
