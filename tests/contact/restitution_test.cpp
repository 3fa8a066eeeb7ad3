// The damping of restitution, against an impact integrated step by step.

#include "contact/restitution.hpp"

#include <cmath>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

struct Impact {
    double depth = 0.0, speed = 1.0;  // into the surface
};

// The rates of a unit mass that is pushed back by λ (1 + c v), λ a stiffness times the depth to this power.
Impact rates_of(const Impact& at, double number, double power) {
    const double force = std::pow(std::max(at.depth, 0.0), power) * std::max(1.0 + number * at.speed, 0.0);
    return {at.speed, -force};
}

Impact step_from(const Impact& at, double number, double power, double step) {
    const auto ahead = [&](const Impact& rate, double part) {
        return Impact{at.depth + part * step * rate.depth, at.speed + part * step * rate.speed};
    };
    const Impact a = rates_of(at, number, power), b = rates_of(ahead(a, 0.5), number, power);
    const Impact c = rates_of(ahead(b, 0.5), number, power), d = rates_of(ahead(c, 1.0), number, power);
    return {at.depth + step / 6.0 * (a.depth + 2.0 * (b.depth + c.depth) + d.depth),
            at.speed + step / 6.0 * (a.speed + 2.0 * (b.speed + c.speed) + d.speed)};
}

// What is left of the speed: the classical Runge-Kutta method, and a last step to the surface.
double find_rebound(double number, double power) {
    constexpr double step = 1e-4;
    Impact at;
    while (true) {
        const Impact next = step_from(at, number, power, step);
        if (next.depth <= 0.0) return -at.speed;
        at = next;
    }
}

}  // namespace

TEST_CASE("The damping of restitution leaves that part of the speed, whatever the law", "[contact][law]") {
    for (const double restitution : {0.9, 0.5, 0.2}) {
        for (const double power : {1.0, 1.5, 2.0}) {
            INFO(restitution << " " << power);
            CHECK(find_rebound(find_damping_number(restitution), power) == Approx(restitution).epsilon(2e-6));
        }
    }
}

TEST_CASE("The damping of restitution has its limits", "[contact][law]") {
    CHECK(find_damping_number(1.0) == 0.0);
    // c = 3/2 (1 − e²)/(1 + e³) near e = 1.
    for (const double loss : {1e-3, 1e-6, 1e-9}) {
        const double e = 1.0 - loss;
        CHECK(find_damping_number(e) ==
              Approx(1.5 * (1.0 - e * e) / (1.0 + e * e * e)).epsilon(2.0 * loss + 1e-6));
    }
    CHECK(find_damping_number(0.01) == Approx(100.0).epsilon(1e-12));
    // As many digits as the table of the guide has: 1.4 for a half.
    CHECK(find_damping_number(0.5) == Approx(1.4).margin(0.05));
}
