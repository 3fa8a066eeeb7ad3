// Contact with schemes of several stages, where it acts at each stage like any other force.
#include "analyses/contact/contact_run.hpp"

namespace gxrod::test {
namespace {

constexpr double radius = 0.05, mass = 0.5, half_force = 400.0;
constexpr double skin = 0.02 * radius;

// Of a ball at the gap g: twice its radius times λ(g) with κ = F/r, for the force F at half the skin.
double find_ball_force(double gap) {
    const double x = gap / skin;
    return x < 1.0 ? 2.0 * half_force * (1.0 - x) * (1.0 - x) / x : 0.0;
}

struct Fall {
    double gap, speed;
};

// The motion m g̈ = f(g) − m g0, by many steps of Kutta's rule.
Fall integrate(Fall fall, double gravity, double damping, double end) {
    constexpr int steps = 400000;
    const double h = end / steps;
    const auto rate = [&](const Fall& at) {
        const double force = find_ball_force(at.gap) * std::max(1.0 - damping * at.speed, 0.0);
        return Fall{at.speed, force / mass - gravity};
    };
    const auto shifted = [](const Fall& at, double by, const Fall& along) {
        return Fall{at.gap + by * along.gap, at.speed + by * along.speed};
    };
    for (int i = 0; i < steps; ++i) {
        const Fall k1 = rate(fall), k2 = rate(shifted(fall, 0.5 * h, k1));
        const Fall k3 = rate(shifted(fall, 0.5 * h, k2)), k4 = rate(shifted(fall, h, k3));
        fall = shifted(fall, h / 6.0, shifted(shifted(shifted(k1, 2.0, k2), 2.0, k3), 1.0, k4));
    }
    return fall;
}

std::string ball(const Fall& start, double gravity, double damping, double end, const std::string& analysis) {
    return fmt::format(R"(
gravity = [0, 0, {:.17g}]
[body.ball]
mass = {}
inertia = [5e-4, 5e-4, 5e-4]
at = [0, 0, {:.17g}]
sphere = {{ radius = {}, force = {} }}
[obstacle.floor]
plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }}
[contact]
damping = {}
[[initial]]
on = "ball"
velocity = [0, 0, {:.17g}]
[analysis]
kind = "dynamic"
end_time = {}
{}
)",
                       -gravity,
                       mass,
                       radius + start.gap,
                       radius,
                       half_force,
                       damping,
                       start.speed,
                       end,
                       analysis);
}

double measure_error(const Fall& start, const Fall& expected, double end, const std::string& analysis) {
    ContactRun run(ball(start, 0.0, 0.0, end, analysis));
    run.finish();
    return std::abs(run.at("ball").r.z() - radius - expected.gap);
}

std::string steps_of(const char* scheme, int steps) {
    return fmt::format("integrator = \"{}\"\nsteps = {}\nnewton = {{ tolerance = 1e-13 }}\n", scheme, steps);
}

}  // namespace

TEST_CASE("Schemes keep their order while steps resolve an impact", "[analyses][touch][stages]") {
    // From within the skin to its way back there; the law has a jump of its second derivative at its edge.
    const Fall start{0.9 * skin, -1.0};
    constexpr double end = 9e-4;
    const Fall expected = integrate(start, 0.0, 0.0, end);
    REQUIRE(expected.speed > 0.1);
    REQUIRE(expected.gap < skin);
    struct Sample {
        const char* scheme;
        int steps;
        double order;
    };
    for (const Sample& one : {Sample{"sdirk-4", 24, 4.0}, Sample{"radau-5", 6, 5.0}}) {
        INFO(one.scheme);
        const double coarse = measure_error(start, expected, end, steps_of(one.scheme, one.steps));
        const double fine = measure_error(start, expected, end, steps_of(one.scheme, 2 * one.steps));
        INFO(coarse << " " << fine);
        CHECK(std::log2(coarse / fine) == Approx(one.order).margin(0.5));
        CHECK(fine < 1e-4 * skin);
    }
}

TEST_CASE("A ball bounces as its law has it, the better the smaller the error asked for",
          "[analyses][touch][stages]") {
    const Fall start{0.05, 0.0};
    constexpr double gravity = 9.81, end = 0.35;  // it is on its way down again
    const Fall expected = integrate(start, gravity, 0.0, end);
    double before = 1.0;
    for (const double accuracy : {1e-4, 1e-6, 1e-8}) {
        INFO(accuracy);
        ContactRun run(ball(start, gravity, 0.0, end, fmt::format("accuracy = {}\n", accuracy)));
        run.finish();
        const double error = std::abs(run.at("ball").r.z() - radius - expected.gap);
        const LedgerRow books = run.ledger();
        CHECK(error < std::min(before, 100.0 * accuracy * radius));
        before = error;
        CHECK(std::abs(books.energy_error) < 100.0 * accuracy * mass * gravity * start.gap);
        CHECK(books.contact_loss == 0.0);
        CHECK(run.least_gap() > 0.0);
    }
}

TEST_CASE("Damping takes from impacts what its integral says, with stages too", "[analyses][touch][stages]") {
    const Fall start{2.0 * skin, -1.0};
    constexpr double end = 4e-3;
    for (const double damping : {0.14, 1.4}) {
        for (const char* analysis : {"accuracy = 1e-7\n", "integrator = \"sdirk-4\"\ntime_step = 1e-5\n"}) {
            INFO(damping << " " << analysis);
            ContactRun run(ball(start, 0.0, damping, end, analysis));
            run.finish();
            const Fall expected = integrate(start, 0.0, damping, end);
            const double speed = run.at("ball").v.z();
            CHECK(speed == Approx(expected.speed).epsilon(1e-4));
            const LedgerRow books = run.ledger();
            CHECK(books.contact_loss == Approx(0.5 * mass * (1.0 - speed * speed)).epsilon(1e-3));
            CHECK(std::abs(books.energy_error) < 1e-3 * mass);
        }
    }
}

TEST_CASE("Steps that do not resolve an impact are cut before it gives energy", "[analyses][touch][stages]") {
    // Uncut, a ball left at up to five times its speed.
    for (const char* scheme : {"sdirk-4", "radau-5"}) {
        for (const double step : {1e-3, 5e-3}) {
            double slowest = 1.0, fastest = 0.0;
            for (int i = 0; i < 6; ++i) {
                const Fall start{2.0 * skin + step * i / 6.0, -1.0};
                const double end = (std::ceil(4.0 * start.gap / step) + 2.0) * step;
                ContactRun run(ball(start,
                                    0.0,
                                    0.0,
                                    end,
                                    fmt::format("integrator = \"{}\"\ntime_step = {}\n", scheme, step)));
                run.finish();
                slowest = std::min(slowest, run.at("ball").v.z());
                fastest = std::max(fastest, run.at("ball").v.z());
            }
            INFO(scheme << " " << step << " " << slowest);
            CHECK(fastest < 1.0 + 1e-4);
            CHECK(fastest > 0.5);
        }
    }
}

namespace {

constexpr double density = 1000.0, thickness = 0.01, length = 0.5;
constexpr double weight = density * M_PI * thickness * thickness * length * 9.81;

std::string lying(double friction, const char* velocity, double end, const std::string& analysis) {
    return fmt::format(R"(
gravity = [0, 0, -9.81]
[section.s]
shape = {{ circle = {{ radius = {} }} }}
material = {{ E = 1e7, nu = 0.3, density = {} }}
damping = {{ kelvin_voigt = 0.01 }}
[obstacle.floor]
plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }}
friction = {}
[contact]
damping = 20
[[initial]]
on = "a"
velocity = [{}]
[analysis]
kind = "dynamic"
end_time = {}
{}
)",
                       thickness,
                       density,
                       friction,
                       velocity,
                       end,
                       analysis) +
           rod("a", "0, 0, 0.01019", "0.5, 0, 0.01019", 4);
}

}  // namespace

TEST_CASE("A rod comes to rest on the floor with error control", "[analyses][touch][stages]") {
    for (const char* analysis : {"accuracy = 1e-4\n", "integrator = \"sdirk-4\"\ntime_step = 1e-2\n"}) {
        INFO(analysis);
        ContactRun run(lying(0.0, "0, 0, 0", 1.0, analysis));
        run.finish();
        CHECK(run.obstacle().force.z() == Approx(-weight).epsilon(1e-3));
        CHECK(run.at("a.start").v.norm() < 1e-4);
        CHECK(run.ledger().contact_loss > 0.0);
    }
}

TEST_CASE("A rod that slides is braked by friction alone", "[analyses][touch][stages]") {
    constexpr double friction = 0.2, speed = 0.5, end = 0.15;
    for (const char* analysis : {"accuracy = 1e-5\n", "integrator = \"sdirk-4\"\ntime_step = 1e-3\n"}) {
        INFO(analysis);
        ContactRun run(lying(friction, "0.5, 0, 0", end, analysis));
        run.finish();
        CHECK(run.at("a.start").v.x() == Approx(speed - friction * 9.81 * end).epsilon(5e-3));
        const double lost = 0.5 * (weight / 9.81) * (speed * speed - std::pow(run.at("a.start").v.x(), 2));
        CHECK(run.ledger().contact_loss == Approx(lost).epsilon(1e-2));
        CHECK(std::abs(run.ledger().energy_error) < 1e-2 * lost);
    }
}

TEST_CASE("A wall that moves does the work that a ball takes along", "[analyses][touch][stages]") {
    // It pushes at 1 m/s: a ball at rest leaves at 2 m/s, whatever the law.
    for (const char* analysis : {"accuracy = 1e-6\n", "integrator = \"sdirk-4\"\ntime_step = 2e-5\n"}) {
        INFO(analysis);
        ContactRun run(ball({3.0 * skin, 0.0}, 0.0, 0.0, 0.01, analysis) +
                       "[obstacle.floor.move]\nz = \"t\"\n");
        run.finish();
        const LedgerRow books = run.ledger();
        CHECK(run.at("ball").v.z() == Approx(2.0).epsilon(1e-4));
        CHECK(books.external_work == Approx(0.5 * mass * 4.0).epsilon(1e-4));
        CHECK(std::abs(books.energy_error) < 1e-4 * mass);
    }
}

TEST_CASE("Rods that collide keep momentum and energy with stages", "[analyses][touch][stages]") {
    const std::string bars = R"(
[section.s]
shape = { circle = { radius = 0.05 } }
material = { E = 1e9, nu = 0.3, density = 1000 }
[contact]
[[initial]]
on = "a"
velocity = [0, 0, -3]
[analysis]
kind = "dynamic"
end_time = 2e-3
)";
    for (const char* analysis : {"accuracy = 1e-6\n", "integrator = \"sdirk-4\"\ntime_step = 5e-6\n"}) {
        INFO(analysis);
        ContactRun run(bars + analysis + rod("a", "0, 0, 0.1012", "0.5, 0, 0.1012", 1, 1) +
                       rod("b", "0, 0, 0", "0.5, 0, 0", 1, 1));
        run.finish();
        // Equal rods exchange their velocities.
        CHECK(run.at("a.start").v.z() == Approx(0.0).margin(3e-3));
        CHECK(run.at("b.start").v.z() == Approx(-3.0).epsilon(1e-3));
        CHECK(std::abs(run.ledger().energy_error) < 1e-3 * run.ledger().kinetic_energy);
    }
}

TEST_CASE("A cantilever that hits a stop moves as short steps with impulses have it",
          "[analyses][touch][stages]") {
    const std::string beam = R"(
gravity = [0, 0, -9.81]
[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e8, nu = 0.3, density = 1000 }
damping = { kelvin_voigt = 2e-3 }
[[support]]
at = "a.start"
fix = "all"
[obstacle.stop]
sphere = { centre = [0.8, 0, -0.08], radius = 0.05 }
[contact]
self = false
each_other = false
dissipation = 0
[analysis]
kind = "dynamic"
end_time = 0.2
)";
    const std::string rods = rod("a", "0, 0, 0", "1, 0, 0", 3);
    ContactRun impulses(beam + "time_step = 5e-5\n" + rods);
    impulses.finish();
    REQUIRE(impulses.obstacle().force.norm() > 0.0);
    const Vec3 expected = impulses.at("a.end").r;
    for (const char* analysis : {"accuracy = 1e-5\n", "integrator = \"sdirk-4\"\naccuracy = 1e-5\n"}) {
        INFO(analysis);
        ContactRun run(beam + analysis + rods);
        run.finish();
        CHECK((run.at("a.end").r - expected).norm() < 2e-4);
        CHECK(run.least_gap() > 0.0);
    }
}

}  // namespace gxrod::test
