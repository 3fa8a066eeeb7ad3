#pragma once

namespace gxrod {

// From here on this process can read files and compute. Whatever would start a program or another process,
// write to a file that is not open yet, remove or rename one, or reach the network ends it with the signal
// SIGSYS. There is no way back. False where the system knows no such limits.
bool allow_reading_only();

}  // namespace gxrod
