#pragma once

namespace gxrod {

// Values of a spring at a step that histories record.
struct SpringValues {
    double elongation = 0.0;   // length less that at which it is free
    double axial_force = 0.0;  // tension, the damper's too
};

}  // namespace gxrod
