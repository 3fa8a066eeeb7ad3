#pragma once

namespace gxrod {

// Says whose shape a structure takes: that of a linear buckling mode under the loads of the first stage, or
// of a mode of vibration without loads.
enum class ModeKind { buckling, vibration };

}  // namespace gxrod
