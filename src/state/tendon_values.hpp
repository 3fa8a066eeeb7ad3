#pragma once

namespace gxrod {

// What a history records of a tendon at a step.
struct TendonValues {
    double length = 0.0;   // of its part within the rod
    double tension = 0.0;  // the same all along; below 0 it pushes
};

}  // namespace gxrod
