#pragma once

namespace gxrod {

// Returns the bytes of memory that this process can use: the least of the machine's memory, the limit of the
// control group that a container or a cluster's job puts it in, and its own limits (ulimit).
double count_usable_bytes();

}  // namespace gxrod
