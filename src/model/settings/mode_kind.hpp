#pragma once

namespace gxrod {

// Whose shape an imperfection has: a linear buckling mode under the loads of the first stage, or a mode of
// vibration without loads.
enum class ModeKind { buckling, vibration };

}  // namespace gxrod
