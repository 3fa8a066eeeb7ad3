#include "environment/spectrum.hpp"

#include <cmath>

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("The spectrum of a sea has the values of the benchmarks", "[environment]") {
    const JonswapSpectrum sea(4.0, 10.0, 3.3), plain(2.0, 8.0, 1.0);
    const double peak = 2.0 * M_PI / 10.0, plain_peak = 2.0 * M_PI / 8.0;
    CHECK(sea.peak_frequency() == peak);
    // By mpmath's adaptive quadrature of all frequencies.
    CHECK(sea.density(peak) == Approx(4.93379118998323).epsilon(1e-14));
    CHECK(sea.density(0.8 * peak) == Approx(.76820277182061).epsilon(2e-14));
    CHECK(sea.density(1.5 * peak) == Approx(.536840818601872).epsilon(1e-14));
    CHECK(sea.mean_period() == Approx(8.34327963389965).epsilon(1e-14));
    CHECK(plain.density(plain_peak) == Approx(.455986546398386).epsilon(1e-14));
    CHECK(plain.mean_period() == Approx(6.17417149350501).epsilon(1e-14));
    // Row F18b: its integral goes to 100 times the peak's frequency, beyond which are 8e-9 of the energy.
    const double covered = sea.share_below(100.0 * peak);
    CHECK(sea.density(peak) / covered == Approx(4.93379123043).epsilon(2e-12));
    CHECK(sea.density(0.8 * peak) / covered == Approx(.768202778118).epsilon(2e-12));
    CHECK(sea.density(1.5 * peak) / covered == Approx(.536840823002).epsilon(2e-12));
    CHECK(plain.density(plain_peak) / plain.share_below(100.0 * plain_peak) ==
          Approx(.455986552098).epsilon(2e-12));
    // The mean period takes in 1e-6 from there: ∫x⁻⁴dx = x⁻³/3, of 0.30499 for the energy.
    CHECK(2.0 * M_PI / sea.mean_period() - peak * 1e-6 / 3.0 / 0.304989721934257 ==
          Approx(.7530827090752 * covered).epsilon(1e-13));
    CHECK(sea.density(0.0) == 0.0);
}

TEST_CASE("The share below a frequency is the integral of the spectrum", "[environment]") {
    for (const double enhancement : {1.0, 3.3, 7.0}) {
        const JonswapSpectrum sea(4.0, 10.0, enhancement);
        const double peak = sea.peak_frequency();
        // By Simpson's rule; the peak, where σ jumps, is an end of pieces.
        double sum = 0.0;
        constexpr int pieces = 4000;
        const double h = peak / pieces;
        for (int i = 0; i < 5 * pieces; ++i) {
            const double w = i * h;
            sum += h / 6.0 * (sea.density(w) + 4.0 * sea.density(w + 0.5 * h) + sea.density(w + h));
            if ((i + 1) % 1000 == 0) {
                INFO(w + h);
                CHECK(sea.share_below(w + h) == Approx(sum).margin(1e-11));  // m₀ = 1
            }
        }
        CHECK(sea.share_below(0.0) == 0.0);
        CHECK(sea.share_below(1e6) == Approx(1.0).epsilon(1e-15));
    }
}

TEST_CASE("Frequencies are found by the share below them", "[environment]") {
    const JonswapSpectrum sea(2.5, 7.0, 3.3);
    for (const double share : {1e-30, 1e-6, 0.01, 0.3, 0.5, 0.9, 0.999}) {
        INFO(share);
        CHECK(sea.share_below(sea.find_frequency(share)) == Approx(share).epsilon(1e-12));
    }
}

}  // namespace gxrod::test
