#include "machine/machine_memory.hpp"

#include <unistd.h>

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("The usable memory is part of the machine's", "[machine]") {
    const double machine =
        static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
    CHECK(count_usable_bytes() <= machine);
    CHECK(count_usable_bytes() > 1e7);
}

}  // namespace gxrod::test
