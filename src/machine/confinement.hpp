#pragma once

namespace gxrod {

// From here on this process can read files and compute. Whatever would start a program or another process, or
// reach the network, ends it with the signal SIGSYS; opening a file to write, removing or renaming one fails
// with EACCES. There is no way back. False where the system knows no such limits.
bool allow_reading_only();

}  // namespace gxrod
