#pragma once

namespace gxrod {

// The derivative by time at which the equations of joints are to hold.
enum class ConstraintLevel { position, velocity, acceleration };

}  // namespace gxrod
