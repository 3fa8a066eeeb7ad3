#pragma once

namespace gxrod {

// At which of their derivatives by time the equations of joints are asked to hold.
enum class ConstraintLevel { position, velocity, acceleration };

}  // namespace gxrod
