#pragma once

namespace gxrod {

// What a history's point belongs to. A body's rotation is its attitude; a rod's counts from t = 0.
enum class PointKind { rod, body, spring, bushing, joint, gear, rod_in_contact };

}  // namespace gxrod
