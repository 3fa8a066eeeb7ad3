#pragma once

#include <array>
#include <functional>

#include "deck/loads/acting.hpp"

namespace gxrod {

// A vector as a function of time and place: a part that is the same everywhere, and a part that depends on
// the place as well.
struct PlaceField {
    std::array<TimeFunction, 3> uniform{};
    // The part by place, in addition; empty if there is none. Two threads must not call it at once.
    std::function<Vec3(double time, const Vec3& position)> by_place{};
};

// Makes the field of a deck's components as they act in a stage.
PlaceField make_field(const CheckedMotionVector& components, const Acting& acting);

}  // namespace gxrod
