#include "benchmarks/memory_peak.hpp"

#include <malloc.h>

#include <fstream>
#include <string>

namespace gxrod::speed {

namespace {

// A line of the kernel's file about this program, which has kB.
double read_status(const std::string& key) {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word) {
        double kilobytes = 0.0;
        if (word == key && status >> kilobytes) return 1024.0 * kilobytes;
    }
    return 0.0;
}

}  // namespace

MemoryPeak::MemoryPeak() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";  // resets the peak
    before_ = read_status("VmRSS:");
}

double MemoryPeak::bytes() const { return read_status("VmHWM:") - before_; }

}  // namespace gxrod::speed
