#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// A force and a moment on a node, Re((force, moment) e^(i(ωt + phase))), global axes.
struct Excitation {
    int node = 0;
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    double phase = 0.0;  // rad
};

// A node whose response is recorded.
struct ResponsePoint {
    std::string name;
    int node = 0;
};

// The response of the model to steady harmonic forces, about a state.
struct ResponseSettings {
    std::vector<double> omegas;  // rad per time, rising; without any the speed of a steady rotation
    std::vector<Excitation> excitation;
    // Gravity fixed in space, whose part across the axis of a steady rotation acts once a revolution.
    std::optional<Vec3> gravity;
    std::vector<ResponsePoint> points;  // the points of the deck's histories at nodes
};

}  // namespace gxrod
