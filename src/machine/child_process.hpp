#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace gxrod {

// Limits of a child process.
struct ChildLimits {
    // After which it is ended, counted from its start or from the last restart_processor_clock(); 0: no
    // limit.
    int processor_seconds = 0;
    // It is ended after so long if it computed next to nothing meanwhile: it waits for what does not come.
    // 0: no limit, as for a slow disk.
    int waiting_seconds = 0;
    bool reads_only = false;  // as machine/confinement.hpp has it
};

// A child process that did not end as it should; what() says how it ended.
class ChildError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// It ran out of memory.
class ChildMemoryError : public ChildError {
  public:
    using ChildError::ChildError;
};

// Does work in a copy of this process and returns the bytes that it returns. Where a library breaks down over
// what it is to read, or does not come back, only the copy is lost. Throws ChildError if that happens, and
// where the work throws; std::system_error if there can be no child.
std::string run_in_child(const std::function<std::string()>& work, const ChildLimits& limits);

// Within such work: it comes along, and has all of its time again. Elsewhere nothing.
void restart_processor_clock();

}  // namespace gxrod
