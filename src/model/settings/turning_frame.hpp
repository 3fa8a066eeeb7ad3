#pragma once

#include <cstddef>
#include <vector>

#include "model/time/time_function.hpp"

namespace gxrod {

// A steady rotation about an axis fixed in space. Either a frame turns, with all that is in it: at the time
// of an equilibrium its axes are the global ones. Or the frame is at rest, and some nodes spin in it, each
// about the axis that it carries, which had the direction of `axis` at t = 0.
struct TurningFrame {
    Vec3 axis = Vec3::UnitZ();  // a unit vector
    Vec3 through = Vec3::Zero();
    TimeFunction speed;               // rad per time, as a function of the load factor
    std::vector<bool> spinning = {};  // by node, in a frame at rest; empty if the frame turns

    bool is_at_rest() const { return !spinning.empty(); }
    bool spins(int node) const {
        return node >= 0 && is_at_rest() && spinning[static_cast<std::size_t>(node)];
    }
    // Returns the spin of a frame that turns.
    Vec3 spin(double load_factor) const { return speed(load_factor) * axis; }
    // Returns the spin of a node in a frame at rest.
    Vec3 spin_of(std::size_t node, const Quat& Lambda, double load_factor) const {
        return spinning[node] ? Vec3(Lambda * spin(load_factor)) : Vec3(Vec3::Zero());
    }
};

}  // namespace gxrod
