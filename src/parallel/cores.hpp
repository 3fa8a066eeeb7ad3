#pragma once

namespace gxrod {

// Cores that this process can use; at least 1.
int count_cores();

}  // namespace gxrod
