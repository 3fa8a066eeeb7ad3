#include "contact/impact_law.hpp"

#include <cmath>

#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("impacts: the slope is the derivative of the force", "[contact]") {
    for (const double theta : {0.0, 0.3, 1.0}) {
        for (const double before : {0.05, 0.11, 0.19, 0.4}) {
            for (const double gap : {0.03, 0.110000001, 0.17, 0.25}) {
                for (const double damping : {0.0, 3.0, 20.0}) {
                    const ImpactLaw law{{0.2, 7.0}, theta, before, damping};
                    const double slope = differentiate(
                        [&](double x) { return compute_impact_force(law, gap + x).force; }, 1e-3 * gap);
                    INFO(theta << " " << before << " " << gap << " " << damping);
                    CHECK(compute_impact_force(law, gap).stiffness ==
                          Approx(-slope).epsilon(1e-6).margin(1e-7));
                }
            }
        }
    }
}

TEST_CASE("impacts: the work on a gap is what the energy gives, or less", "[contact]") {
    RandomValues random(7);
    for (int sample = 0; sample < 1000; ++sample) {
        ImpactLaw law{{0.2, 7.0}, 0.0, random.number(1e-3, 0.3)};
        const double gap = random.number(1e-3, 0.3);
        const double given =
            compute_contact_energy(law.law, law.gap_before) - compute_contact_energy(law.law, gap);
        const double work = compute_impact_force(law, gap).force * (gap - law.gap_before);
        CHECK(work == Approx(given).epsilon(1e-9).margin(1e-14));
        for (const double dissipation : {1.0, 0.0}) {
            law.dissipation = dissipation;
            law.damping = random.number(0.0, 10.0);
            const double force = compute_impact_force(law, gap).force;
            CHECK(force * (gap - law.gap_before) <= given + 1e-9 * std::abs(given));
            CHECK(force >= 0.0);
        }
    }
}

TEST_CASE("impacts: a force and a gap belong to the curve's point with the same difference", "[contact]") {
    RandomValues random(9);
    for (int sample = 0; sample < 500; ++sample) {
        const ImpactLaw law{{0.2, 7.0},
                            sample % 3 == 0 ? 1.0 : random.number(0.0, 1.0),
                            random.number(1e-3, 0.3),
                            sample % 2 == 0 ? 0.0 : random.number(0.0, 30.0)};
        const double gap = random.number(-0.3, 0.3);
        const double force = random.number(-20.0, 40.0);
        const double found = find_gap_on_curve(law, force, gap);
        REQUIRE(found > 0.0);
        const double zeta = force / 7.0 - gap / 0.2;
        CHECK(compute_impact_force(law, found).force / 7.0 - found / 0.2 ==
              Approx(zeta).epsilon(1e-10).margin(1e-10));
    }
    SECTION("one on the curve is found again") {
        const ImpactLaw law{{0.2, 7.0}, 0.4, 0.15};
        const double force = compute_impact_force(law, 0.05).force;
        CHECK(find_gap_on_curve(law, force, 0.05) == Approx(0.05).epsilon(1e-12));
    }
}

TEST_CASE("impacts: Newton's method by the curve finds the gap that a spring leaves", "[contact]") {
    // A spring c pulls a point to the gap −a: c (g + a) = λ(g).
    const double a = 0.1;
    for (const double theta : {1.0, 0.3}) {
        for (const double c : {1.0, 1e4, 1e9}) {
            for (const double start : {0.5, 50.0}) {
                INFO(theta << " " << c << " from " << start);
                const ImpactLaw law{{0.02, 30.0}, theta, 0.015};
                double gap = start * law.law.skin, on_curve = gap;
                int iterations = 0;
                for (; iterations < 60; ++iterations) {
                    const NormalForce point = compute_impact_force(law, on_curve);
                    const auto tangent = [&](double g) {
                        return point.force - point.stiffness * (g - on_curve);
                    };
                    const double change = (tangent(gap) - c * (gap + a)) / (c + point.stiffness);
                    on_curve = find_gap_on_curve(law, tangent(gap + change), gap + change);
                    // As much of the way as leaves a tenth of the gap.
                    gap += std::max(change, -0.9 * gap);
                    if (std::abs(change) < 1e-13 * gap) break;
                }
                CHECK(iterations < 40);
                CHECK(compute_impact_force(law, gap).force == Approx(c * (gap + a)).epsilon(1e-10));
            }
        }
    }
}

TEST_CASE("impacts: increments far beyond the surface, one after another, leave a finite force",
          "[contact]") {
    for (const double theta : {0.0, 1.0}) {
        const ImpactLaw law{{0.2, 7.0}, theta, 0.1};
        double on_curve = 0.1;
        for (int iteration = 0; iteration < 20; ++iteration) {
            const NormalForce point = compute_impact_force(law, on_curve);
            const double gap = -10.0;
            on_curve = find_gap_on_curve(law, point.force - point.stiffness * (gap - on_curve), gap);
            INFO(theta << " " << iteration << " " << on_curve);
            REQUIRE(on_curve > 0.0);
        }
        CHECK(std::isfinite(compute_impact_force(law, on_curve).stiffness));
    }
}
