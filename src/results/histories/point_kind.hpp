#pragma once

namespace gxrod {

// The kind of thing that a history's point belongs to. The rotation of a body is its attitude; of a rod, it
// counts from t = 0.
enum class PointKind { rod, body, spring, bushing, joint, gear, rod_in_contact };

}  // namespace gxrod
