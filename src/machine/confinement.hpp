#pragma once

namespace gxrod {

// Confines this process to reading files and computing, for good. An attempt to start a program or process or
// to reach the network ends it with the signal SIGSYS; opening a file to write, removing or renaming one
// fails with EACCES. Returns false if the system has no such limits.
bool allow_reading_only();

}  // namespace gxrod
