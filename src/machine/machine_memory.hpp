#pragma once

namespace gxrod {

// Bytes of memory that the processes of this one's group can use in all: those of the machine, or of the
// control group that a container or a cluster's job puts them in, and this one by its own limits (ulimit).
double count_usable_bytes();

}  // namespace gxrod
