#pragma once

#include "model/time/time_function.hpp"

namespace gxrod {

// A frame that turns steadily about an axis fixed in space. At the time of an equilibrium its axes are the
// global ones.
struct TurningFrame {
    Vec3 axis = Vec3::UnitZ();  // a unit vector
    Vec3 through = Vec3::Zero();
    TimeFunction speed;  // rad per time, as a function of the load factor

    Vec3 spin(double load_factor) const { return speed(load_factor) * axis; }
};

}  // namespace gxrod
