#pragma once

namespace gxrod {

// What a history's point is part of. A body's rotation is its attitude, a rod's counts from t = 0.
enum class PointKind { rod, body };

}  // namespace gxrod
