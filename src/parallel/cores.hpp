#pragma once

namespace gxrod {

// Cores that this process may use; at least 1.
int count_cores();

}  // namespace gxrod
