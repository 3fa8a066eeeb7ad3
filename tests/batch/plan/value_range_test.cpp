#include "batch/plan/value_range.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Numbers are written with all of their digits, whole ones without a point", "[batch]") {
    CHECK(write_number(5.0) == "5");
    CHECK(write_number(-3.0) == "-3");
    CHECK(write_number(0.1) == "0.1");
    CHECK(write_number(1.0 / 3.0) == "0.3333333333333333");
    CHECK(write_number(1e300) == "1e+300");
    CHECK(write_number(0.0) == "0");
}

TEST_CASE("Ranges have equal differences or ratios, and the ends as given", "[batch]") {
    CHECK(space_out(0.0, 1.0, 5, Spacing::linear) == std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0});
    CHECK(space_out(0.1, 0.001, 3, Spacing::log) == std::vector<double>{0.1, 0.01, 0.001});
    CHECK(space_out(-1.0, -100.0, 3, Spacing::log) == std::vector<double>{-1.0, -10.0, -100.0});
    CHECK(space_out(0.0, 0.3, 4, Spacing::linear) == std::vector<double>{0.0, 0.1, 0.2, 0.3});
    const double third = 1.0 / 3.0;
    CHECK(space_out(third, 2.0 * third, 2, Spacing::linear) == std::vector<double>{third, 2.0 * third});
    // Neither rounded together nor out of range.
    const std::vector<double> near = space_out(1.0, 1.0 + 0x1p-51, 3, Spacing::linear);
    CHECK(near == std::vector<double>{1.0, 1.0 + 0x1p-52, 1.0 + 0x1p-51});
    CHECK(space_out(-1e308, 1e308, 3, Spacing::linear) == std::vector<double>{-1e308, 0.0, 1e308});
    CHECK(space_out(1e-310, 2e-310, 3, Spacing::linear) == std::vector<double>{1e-310, 1.5e-310, 2e-310});
    const std::vector<double> ratios = space_out(1.0, 2.0, 13, Spacing::log);
    CHECK(ratios[1] == Approx(1.0594630943592953).epsilon(1e-14));
}

}  // namespace gxrod::test
