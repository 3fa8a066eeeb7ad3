#pragma once

namespace gxrod {

// Counts the cores that this process can use; at least 1.
int count_cores();

}  // namespace gxrod
