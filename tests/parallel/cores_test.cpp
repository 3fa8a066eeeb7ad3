#include "parallel/cores.hpp"

#include <sched.h>

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("Cores are those that the process can use", "[parallel]") {
    cpu_set_t all;
    REQUIRE(sched_getaffinity(0, sizeof(all), &all) == 0);
    CHECK(count_cores() == CPU_COUNT(&all));
    int core = 0;
    while (!CPU_ISSET(core, &all)) ++core;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core, &one);
    REQUIRE(sched_setaffinity(0, sizeof(one), &one) == 0);
    CHECK(count_cores() == 1);
    REQUIRE(sched_setaffinity(0, sizeof(all), &all) == 0);
}
