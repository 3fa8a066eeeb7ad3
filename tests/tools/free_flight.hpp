#pragma once

#include "model/model.hpp"

namespace gxrod::tools {

// A flexible rod in free flight in space (Simo & Vu-Quoc 1988): 10 long, at rest from (6,0,0) to (0,8,0),
// driven at its start by the force (m/10, 0, 0) and the moment (0, −m/2, −m), then free;
// m = 200 sin²(πt/5) over 5 s. Elements simo, order 1.
Model make_free_flight(int elements);

}  // namespace gxrod::tools
