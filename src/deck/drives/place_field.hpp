#pragma once

#include <array>
#include <functional>

#include "deck/loads/acting.hpp"

namespace gxrod {

// A vector by time and place: what is the same everywhere, and what depends on the place as well.
struct PlaceField {
    std::array<TimeFunction, 3> uniform{};
    // In addition; empty without one. Not for two threads at once.
    std::function<Vec3(double time, const Vec3& position)> by_place{};
};

// The components of a deck as they act in a stage.
PlaceField make_field(const CheckedMotionVector& components, const Acting& acting);

}  // namespace gxrod
