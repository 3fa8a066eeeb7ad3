#include "parallel/cores.hpp"

#include <sched.h>

#include <algorithm>
#include <memory>

namespace gxrod {

int count_cores() {
    // The kernel refuses sets that are too small for the machine's cores.
    constexpr int first = 1024;
    constexpr int last = 1 << 20;
    for (int cores = first; cores <= last; cores *= 2) {
        const std::size_t size = CPU_ALLOC_SIZE(cores);
        const auto free = [](cpu_set_t* set) { CPU_FREE(set); };
        const std::unique_ptr<cpu_set_t, decltype(free)> set(CPU_ALLOC(cores), free);
        if (set && ::sched_getaffinity(0, size, set.get()) == 0)
            return std::max(CPU_COUNT_S(size, set.get()), 1);
    }
    return 1;
}

}  // namespace gxrod
