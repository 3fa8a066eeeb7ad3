// `damping` of [contact]: the loss of impacts does not depend on the law nor on the step.
#include "analyses/contact/contact_run.hpp"

namespace gxrod::test {
namespace {

constexpr double speed = 3.0;

// What is left of the speed. With the force λ(g) (1 − τ ġ), m v dv/(1 − τ v) = λ dg; λ is the same on the way
// back, so the integral of the left side over both ways is zero: of v0 before and v1 after the impact
//   τ v0 − ln(1 + τ v0) = −τ v1 − ln(1 − τ v1).
double find_restitution(double tau_speed) {
    const double given = tau_speed - std::log1p(tau_speed);
    double low = 0.0, high = 1.0;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (-middle - std::log1p(-middle) < given ? low : high) = middle;
    }
    return low / tau_speed;
}

std::string impact(double damping, double step, double end) {
    return fmt::format(R"(
[section.s]
shape = {{ circle = {{ radius = 0.05 }} }}
material = {{ E = 1e9, nu = 0.3, density = 1000 }}
[contact]
damping = {}
dissipation = 0
[[initial]]
on = "a"
velocity = [0, 0, {}]
[analysis]
kind = "dynamic"
time_step = {}
end_time = {}
)",
                       damping,
                       -speed,
                       step,
                       end);
}

const std::string ground = "[obstacle.floor]\nplane = { point = [0, 0, 0], normal = [0, 0, 1] }\n";

// Two parallel rods; only the first one moves.
std::string collision(double tau_speed) {
    return impact(tau_speed / speed, 1e-6, 5e-3) + rod("a", "0, 0, 0.1012", "0.5, 0, 0.1012", 1, 1) +
           rod("b", "0, 0, 0", "0.5, 0, 0", 1, 1);
}

}  // namespace

TEST_CASE("Rebounds are as high as damping leaves them, at any step", "[analyses][touch]") {
    // As many digits as the design's table of rebounds has.
    CHECK(std::pow(find_restitution(0.014), 2) == Approx(0.98).margin(0.005));
    CHECK(std::pow(find_restitution(0.14), 2) == Approx(0.84).margin(0.01));
    CHECK(std::pow(find_restitution(1.4), 2) == Approx(0.26).margin(0.01));
    CHECK(std::pow(find_restitution(14.0), 2) == Approx(0.01).margin(0.005));
    const double mass = 1000.0 * M_PI * 0.05 * 0.05;
    for (const double tau_speed : {0.014, 0.14, 1.4, 14.0}) {
        for (const double step : {5e-6, 2e-5}) {
            INFO(tau_speed << " " << step);
            ContactRun run(impact(tau_speed / speed, step, 0.02) + ground +
                           rod("a", "0, 0, 0.0512", "1, 0, 0.0512", 1));
            run.finish();
            const double left = run.at("a.start").v.z() / speed;
            const double expected = find_restitution(tau_speed);
            CHECK(left == Approx(expected).epsilon(2e-3));
            const LedgerRow ledger = run.ledger();
            const double energy = 0.5 * mass * speed * speed;
            CHECK(std::abs(ledger.contact_loss - energy * (1.0 - expected * expected)) < 1e-3 * energy);
            CHECK(std::abs(ledger.energy_error) < 1e-9 * mass * speed * speed);
            CHECK(run.least_gap() > 0.0);
        }
    }
}

TEST_CASE("Rods that collide lose what damping takes, and keep their momentum", "[analyses][touch]") {
    for (const double tau_speed : {0.14, 1.4}) {
        INFO(tau_speed);
        ContactRun run(collision(tau_speed));
        run.finish();
        const double a = run.at("a.start").v.z(), b = run.at("b.start").v.z();
        CHECK(a + b == Approx(-speed).epsilon(1e-9));
        CHECK((a - b) / speed == Approx(find_restitution(tau_speed)).epsilon(0.03));
    }
}

TEST_CASE("Damping never gives energy and never pulls, however long steps are", "[analyses][touch]") {
    for (const double step : {1e-3, 5e-2}) {
        for (const double damping : {0.1, 100.0}) {
            INFO(step << " " << damping);
            ContactRun run("gravity = [0, 0, -9.81]\n" + impact(damping, step, 2.0) + ground +
                           rod("a", "0, 0, 0.1", "1, 0, 0.1", 4));
            double before = 1e300;
            while (!run.is_finished()) {
                run.step();
                const LedgerRow row = run.ledger();
                const double total =
                    row.kinetic_energy + row.strain_energy + row.contact_energy - row.external_work;
                CHECK(total < before + 1e-9 * 38.5);
                before = total;
                CHECK(run.obstacle().force.z() <= 0.0);
            }
        }
    }
}

TEST_CASE("A damped rod that stands on a plane comes to rest, and its energy balances", "[analyses][touch]") {
    const std::string stands = R"(
gravity = [0, 0, -9.81]
[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e7, nu = 0.3, density = 1000 }
damping = { kelvin_voigt = 0.05 }
[[support]]
at = "a.start"
fix = ["x", "y", "rotation"]
[contact]
[analysis]
kind = "dynamic"
newton = { tolerance = 1e-12 }
time_step = 0.01
end_time = 2
)";
    const std::string below = ground + rod("a", "0, 0, 0.0102", "0, 0, 0.5102", 10, 1);
    const double fall = 1000.0 * M_PI * 1e-4 * 0.5 * 9.81 * 2e-4;  // its weight's work
    for (const double gamma : {0.5, 0.6, 1.0}) {
        INFO(gamma);
        ContactRun run(stands + fmt::format("gamma = {}\nbeta = {}\n", gamma, 0.5 * gamma) + below);
        run.finish();
        CHECK(run.at("a.start").v.norm() < (gamma > 0.5 ? 1e-12 : 1e-2));
        CHECK(std::abs(run.ledger().energy_error) < (gamma > 0.5 ? 0.05 : 1e-9) * fall);
    }
}

}  // namespace gxrod::test
