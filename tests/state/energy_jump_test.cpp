#include "state/energy_jump.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("A jump is an imbalance beyond the uncertainty of the work and a hundredth of the energy",
          "[state]") {
    const EnergyPoint before{0.4, 5.0, 7.0, 100.0};
    // Strain energy rises by 1.
    CHECK_FALSE(find_jump(before, {0.5, 6.0, 9.0, 1.0}, 0.0));
    CHECK_FALSE(find_jump(before, {0.5, 6.0, 9.5, 1.25}, 25.0));
    const auto lost = find_jump(before, {0.5, 6.0, 9.5, 1.25}, 24.0);
    REQUIRE(lost);
    CHECK(lost->from == 0.4);
    CHECK(lost->to == 0.5);
    CHECK(lost->energy == 0.25);
    const auto gained = find_jump(before, {0.5, 6.0, 7.0, 0.75}, 1.0);
    REQUIRE(gained);
    CHECK(gained->energy == 0.25);
}

TEST_CASE("The largest jump is kept", "[state]") {
    EnergyJumps jumps;
    add_jump({0.1, 0.2, 3.0}, jumps);
    add_jump({0.2, 0.3, 5.0}, jumps);
    add_jump({0.5, 0.6, 4.0}, jumps);
    CHECK(jumps.count == 3);
    CHECK(jumps.largest.from == 0.2);
    CHECK(jumps.largest.to == 0.3);
    CHECK(jumps.largest.energy == 5.0);
}
