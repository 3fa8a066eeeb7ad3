#pragma once

namespace gxrod {

// The shape of the curve on which the mean tension of a rope falls and returns below its largest one.
enum class WorkingShape { linear, quadratic, exponential };

}  // namespace gxrod
