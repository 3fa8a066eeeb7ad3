// Tubes under pressure.
#include "model/sections/pressed_tube.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("A tube under pressure has Lamé's stresses", "[model]") {
    const PressedTube tube{.inner = 0.08, .outer = 0.1};
    const Pressures pressures{.inside = 7e6, .outside = 2e6};
    const auto radial = [&](double r) { return tube.compute_stress(pressures, {r, 0.0})[1]; };
    const auto hoop = [&](double r) { return tube.compute_stress(pressures, {r, 0.0})[2]; };
    CHECK(radial(0.08) == Approx(-7e6).epsilon(1e-14));
    CHECK(radial(0.1) == Approx(-2e6).epsilon(1e-14));
    // Timoshenko & Goodier, (46): σ_θ at the inner surface.
    CHECK(hoop(0.08) == Approx((7e6 * (0.01 + 0.0064) - 2.0 * 2e6 * 0.01) / (0.01 - 0.0064)).epsilon(1e-14));
    for (const double r : {0.083, 0.09, 0.097}) {
        // In equilibrium: d(r σ_r)/dr = σ_θ.
        const double h = 1e-4;
        const double slope = ((r + h) * radial(r + h) - (r - h) * radial(r - h)) / (2.0 * h);
        CHECK(slope == Approx(hoop(r)).epsilon(1e-5));
        // The same all round, in axes that turn.
        const Vec6 turned = tube.compute_stress(pressures, {0.6 * r, 0.8 * r});
        CHECK(turned[1] == Approx(0.36 * radial(r) + 0.64 * hoop(r)).epsilon(1e-13));
        CHECK(turned[2] == Approx(0.64 * radial(r) + 0.36 * hoop(r)).epsilon(1e-13));
        CHECK(turned[3] == Approx(0.48 * (radial(r) - hoop(r))).epsilon(1e-13));
        CHECK(turned[0] == Approx((7e6 * 0.0064 - 2e6 * 0.01) / 0.0036).epsilon(1e-13));
    }
}

TEST_CASE("Pressures are recovered from the force on the wall", "[model]") {
    Water water{.density = 1025.0};
    water.surface = 10.0;
    const SectionInFluid mud{
        .area = 0.03, .contents_area = 0.02, .contents_density = 1300.0, .contents_pressure = 3e6};
    const SectionInFluid empty{.area = 0.03};
    for (const SectionInFluid& section : {mud, empty}) {
        for (const double z : {-25.0, 30.0}) {
            const Pressures wanted = compute_pressures(section, water, 9.81, z);
            const double force = wanted.inside * section.contents_area - wanted.outside * section.area;
            const Pressures found = recover_pressures(section, water, force, z);
            CHECK(found.outside == Approx(wanted.outside).epsilon(1e-12));
            if (section.contents_area > 0.0) CHECK(found.inside == Approx(wanted.inside).epsilon(1e-12));
        }
    }
}
