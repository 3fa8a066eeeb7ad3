#include "model/spring_law.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("a spring's law is differentiated by length and by rate", "[model]") {
    const SpringLaw law(
        [](double l, double r) { return 1e6 + 3.0 * l * l + 5.0 * l * r + 2.0 * r * r * r; }, true, 0.8);
    const double l = 1.7;
    const double r = -0.6;
    CHECK(law.differentiate_by_length(l, r) == Approx(6.0 * l + 5.0 * r).epsilon(1e-5));
    CHECK(law.differentiate_by_rate(l, r, 200.0) == Approx(5.0 * l + 6.0 * r * r).epsilon(1e-5));
    // Standing still, or nearly so.
    CHECK(law.differentiate_by_rate(l, 0.0, 200.0) == Approx(5.0 * l).epsilon(1e-5));
    CHECK(law.differentiate_by_rate(l, 1e-17, 200.0) == Approx(5.0 * l).epsilon(1e-5));
    CHECK(law.differentiate_by_rate(l, 0.0, 0.0) == 0.0);  // nothing moves
}

TEST_CASE("on a kink the derivative of a law is the mean of both sides", "[model]") {
    const SpringLaw law([](double l, double) { return l > 1.0 ? 8.0 * (l - 1.0) : 0.0; }, false, 1.0);
    CHECK(law.differentiate_by_length(1.0, 0.0) == Approx(4.0).epsilon(1e-9));
    CHECK(law.differentiate_by_length(1.1, 0.0) == Approx(8.0).epsilon(1e-9));
    CHECK(law.differentiate_by_length(0.9, 0.0) == 0.0);
}
