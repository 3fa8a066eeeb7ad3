#include "machine/machine_memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace gxrod {
namespace {

// The folder of this process's control group (version 2), from the root of all.
std::string find_control_group() {
    std::ifstream groups("/proc/self/cgroup");
    const std::string mark = "0::";
    for (std::string line; std::getline(groups, line);) {
        if (line.starts_with(mark)) return line.substr(mark.size());
    }
    return "/";
}

}  // namespace

double count_usable_bytes() {
    double bytes =
        static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
    for (const auto limited : {RLIMIT_AS, RLIMIT_DATA}) {
        rlimit limit{};
        if (::getrlimit(limited, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
            bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
        }
    }
    // A limit of any group around it counts.
    std::string group = find_control_group();
    while (!group.empty()) {
        std::ifstream limit("/sys/fs/cgroup" + group + "/memory.max");
        double most = 0.0;
        if (limit >> most) bytes = std::min(bytes, most);  // "max" is not a number
        group.erase(group.rfind('/'));
    }
    return bytes;
}

}  // namespace gxrod
