#pragma once

namespace gxrod {

// Values of a tendon at a step that histories record.
struct TendonValues {
    double length = 0.0;   // length of its part within the rod
    double tension = 0.0;  // at the end that is pulled, and everywhere without friction; below 0 it pushes
    double end_tension = 0.0;  // at its other end, where it is anchored
};

}  // namespace gxrod
