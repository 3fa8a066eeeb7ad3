#include "results/energy_warning.hpp"

#include <catch2/catch.hpp>

using namespace gxrod;

TEST_CASE("An imbalance above a tenth of the largest energy is told with both", "[results]") {
    CHECK(describe_imbalance(0.0, 0.0, 0.0).empty());
    CHECK(describe_imbalance(20.0, 2.0, 0.0).empty());
    CHECK(describe_imbalance(1e-20, 2e-20, 2e-20).empty());
    CHECK_THAT(describe_imbalance(20.0, 2.001, 2.0),
               Catch::StartsWith("the energy does not balance: an error of 2 beside an energy of 20 "));
}
