#include "results/energy_warning.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

std::string describe_dynamic(double largest, double error, double round_off) {
    return describe_imbalance({false, largest, error, {5, {0.1, 0.2, 1e3}}}, round_off);
}

std::string describe_static(const EnergyJumps& jumps, double round_off) {
    return describe_imbalance({true, 20.0, 1e3, jumps}, round_off);
}

}  // namespace

TEST_CASE("In dynamics an imbalance above a tenth of the largest energy is reported with both", "[results]") {
    CHECK(describe_dynamic(0.0, 0.0, 0.0).empty());
    CHECK(describe_dynamic(20.0, 2.0, 0.0).empty());
    CHECK(describe_dynamic(1e-20, 2e-20, 2e-20).empty());
    CHECK_THAT(
        describe_dynamic(20.0, 2.001, 2.0),
        Catch::StartsWith("the energy does not balance: an error of 2 compared with an energy of 20 ") &&
            !Catch::Contains("jump"));
}

TEST_CASE("In statics jumps are reported with the load factors of the largest, and nothing else",
          "[results]") {
    CHECK(describe_static({}, 0.0).empty());
    CHECK(describe_static({2, {0.4, 0.5, 3.0}}, 3.0).empty());
    CHECK_THAT(describe_static({1, {0.4, 0.5, 3.0}}, 0.0),
               Catch::StartsWith("the structure jumps between t = 0.4 and t = 0.5: ") &&
                   Catch::Contains("by at least 3, compared with an energy of 20. "));
    CHECK_THAT(describe_static({2, {0.4, 0.5, 3.0}}, 0.0), Catch::Contains("; 2 load steps jump"));
}
