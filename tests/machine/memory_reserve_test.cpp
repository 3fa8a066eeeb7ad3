#include "machine/memory_reserve.hpp"

#include <limits>
#include <new>

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("Memory that a process cannot have is refused before it is needed", "[machine]") {
    CHECK_NOTHROW(require_memory(hdf5_reserve));
    CHECK_THROWS_AS(require_memory(std::numeric_limits<std::size_t>::max() / 4), std::bad_alloc);
}
