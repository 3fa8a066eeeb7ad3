#pragma once

namespace gxrod {

// What a history records of a tendon at a step.
struct TendonValues {
    double length = 0.0;       // of its part within the rod
    double tension = 0.0;      // where it is pulled, and all along without friction; below 0 it pushes
    double end_tension = 0.0;  // at its other end, where it is anchored
};

}  // namespace gxrod
