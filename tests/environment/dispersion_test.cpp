#include "environment/dispersion.hpp"

#include <cmath>
#include <limits>

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Wave numbers have the digits of the benchmarks", "[environment]") {
    // Row F18a: ω = 2π/T over a depth, g = 9.81.
    const auto number = [](double period, double depth) {
        return find_wave_number(2.0 * M_PI / period, depth, 9.81);
    };
    CHECK(number(10, 50) == Approx(.0415284525207225991).epsilon(4e-16));
    CHECK(number(6, 10) == Approx(.129801243586241786).epsilon(4e-16));
    CHECK(number(14, 20) == Approx(.0344056081418768292).epsilon(4e-16));
}

TEST_CASE("Waves of every frequency obey the dispersion relation", "[environment]") {
    for (double y = 1e-12; y < 1e6; y *= 1.7) {
        INFO(y);
        // ω²d/g = y, with d = 20.
        const double x = 20.0 * find_wave_number(std::sqrt(y * 9.81 / 20.0), 20.0, 9.81);
        // In extended precision, by which the relation can be asked to round-off.
        const long double tangent = std::tanh(static_cast<long double>(x));
        CHECK(std::abs(static_cast<double>(x * tangent / y - 1.0L)) < 1.5e-15);
    }
}

TEST_CASE("Long waves are those of shallow water, short ones those of deep water", "[environment]") {
    const double slow = 1e-4;
    CHECK(find_wave_number(slow, 5.0, 9.81) == Approx(slow / std::sqrt(9.81 * 5.0)).epsilon(2e-9));
    CHECK(find_wave_number(10.0, 50.0, 9.81) == Approx(100.0 / 9.81).epsilon(1e-15));
    CHECK(find_wave_number(10.0, {}, 9.81) == 100.0 / 9.81);
}

}  // namespace gxrod::test
