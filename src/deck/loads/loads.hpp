#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds gravity and the loads, at points and along rods, to the model. After build_bodies.
void build_loads(BuildContext& context);

// A force at a point of a rod or a body, global.
struct SteadyLoad {
    std::string point;
    Vec3 force;
};

// Lists the forces of the first stage at points that do not depend on the motion and are fixed in space: at
// full load, or at t = 0 if it has time.
std::vector<SteadyLoad> list_steady_loads(const BuildContext& context);

// Sets the frame that turns, if the deck has one.
void build_rotation(BuildContext& context);

}  // namespace gxrod
