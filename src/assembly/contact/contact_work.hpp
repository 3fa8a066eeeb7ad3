#pragma once

namespace gxrod {

// Power of contact at one instant.
struct ContactPower {
    double by_obstacles = 0.0;  // power of moving obstacles on rods
    double damping = 0.0;       // dissipated by damping
    bool touches = false;       // whether anything is within its skin
};

// Work of contact in a step.
struct ContactWork {
    double by_obstacles = 0.0;  // work of moving obstacles on rods
    double loss = 0.0;          // lost by impacts and friction
    double uncertainty = 0.0;   // uncertainty of their sum, in statics
};

}  // namespace gxrod
