#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace gxrod {

// Limits of a child process.
struct ChildLimits {
    // Processor time after which the child is ended, counted from its start or from the last
    // restart_processor_clock(); 0: no limit.
    int processor_seconds = 0;
    // The child is ended if it computes next to nothing for so long: it waits in vain. 0: no limit, for slow
    // disks.
    int waiting_seconds = 0;
    bool reads_only = false;  // see machine/confinement.hpp
};

// A child process that did not end as it should; what() says how it ended.
class ChildError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The child ran out of memory.
class ChildMemoryError : public ChildError {
  public:
    using ChildError::ChildError;
};

// Does work in a copy of this process and returns the bytes that it returns. If a library crashes or hangs on
// the data that it reads, only the copy is lost. Throws ChildError if that happens or if the work throws;
// std::system_error if no child can be started.
std::string run_in_child(const std::function<std::string()>& work, const ChildLimits& limits);

// Gives the child all of its processor time again: the work calls it when it makes progress. Does nothing
// elsewhere.
void restart_processor_clock();

}  // namespace gxrod
