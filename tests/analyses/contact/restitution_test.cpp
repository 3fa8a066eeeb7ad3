// Restitution: impacts are left at the part of the speed that the deck says, once steps resolve them.
#include "analyses/contact/contact_run.hpp"

namespace gxrod::test {
namespace {

constexpr double approach = 3.0;  // speed

std::string thrown(const char* name, const std::string& keys) {
    return fmt::format("[body.{}]\nmass = 2\ninertia = [0.02, 0.02, 0.02]\n{}\n", name, keys);
}

const std::string falling_ball =
    thrown("ball", "at = [0, 0, 0.103]\nvelocity = [0, 0, -3]\nsphere = { radius = 0.1, force = 2e5 }");
const std::string ground = "[obstacle.floor]\nplane = { point = [0, 0, 0], normal = [0, 0, 1] }\n";

std::string timed(const std::string& keys, double end = 8e-3) {
    return fmt::format("[analysis]\nkind = \"dynamic\"\nend_time = {}\n{}\n", end, keys);
}

const std::string resolved = "integrator = \"radau-5\"\naccuracy = 1e-7\n";

// How much less than e times the speed of the approach is left with steps of this length.
double find_lack(double e, double step) {
    ContactRun run(falling_ball + ground + fmt::format("restitution = {}\n", e) +
                   timed(fmt::format("time_step = {}", step)));
    run.finish();
    return e - run.at("ball").v.z() / approach;
}

}  // namespace

TEST_CASE("A ball leaves an obstacle at the speed that restitution says", "[analyses][touch][bodies]") {
    for (const double e : {1.0, 0.8, 0.1}) {
        const std::string own = fmt::format("restitution = {}\n", e);
        for (const std::string& deck :
             {ground + own,
              "[contact]\n" + own + ground,
              "[contact]\nrestitution = 0.3\n" + ground + own,
              ground + "[contact]\n[[contact.pair]]\nbetween = [\"ball\", \"floor\"]\n" + own,
              "[obstacle.floor]\nsphere = { centre = [0, 0, -1], radius = 1 }\n" + own}) {
            INFO(deck);
            ContactRun run(falling_ball + deck + timed(resolved));
            run.finish();
            CHECK(run.at("ball").v.z() == Approx(e * approach).epsilon(1e-6));
            CHECK(run.ledger().contact_loss ==
                  Approx(approach * approach * (1.0 - e * e)).margin(2e-6 * approach * approach));
            CHECK(std::abs(run.ledger().energy_error) < 1e-6 * approach * approach);
        }
    }
}

TEST_CASE("Rebounds of impulses come to restitution by the square of the step", "[analyses][touch][bodies]") {
    for (const double e : {0.8, 0.4}) {
        const double coarse = find_lack(e, 2e-5), fine = find_lack(e, 1e-5), finest = find_lack(e, 5e-6);
        INFO(e << ": " << coarse << " " << fine << " " << finest);
        CHECK(std::abs(coarse) < 1e-3);
        CHECK(coarse / fine == Approx(4.0).margin(0.8));
        CHECK(fine / finest == Approx(4.0).margin(0.8));
        // As both together say.
        CHECK(std::abs(finest + (finest - fine) / 3.0) < 2e-6);
    }
    // Nothing is lost with e = 1, whatever the step.
    for (const double step : {1e-3, 1e-5}) CHECK(std::abs(find_lack(1.0, step)) < 1e-9);
}

TEST_CASE("An obstacle that moves has restitution for the speed between both", "[analyses][touch][bodies]") {
    const std::string resting = thrown("ball", "at = [0, 0, 0.103]\nsphere = { radius = 0.1, force = 2e5 }");
    for (const std::string& scheme : {resolved, std::string("time_step = 5e-6\n")}) {
        INFO(scheme);
        ContactRun run(resting + ground + "restitution = 0.6\nmove = { z = \"3*t\" }\n" + timed(scheme));
        run.finish();
        CHECK(run.at("ball").v.z() == Approx(1.6 * approach).epsilon(scheme == resolved ? 1e-5 : 5e-5));
    }
}

TEST_CASE("Balls and capsules leave each other at the speed that restitution says",
          "[analyses][touch][bodies]") {
    const std::string resting = thrown("other", "at = [0, 0, -0.1]\nsphere = { radius = 0.1, force = 2e5 }");
    const std::string across =
        thrown("other",
               "at = [0, 0, -0.1]\ncapsule = { from = [-0.3, 0, 0], to = [0.3, 0, 0], radius = 0.1, "
               "force = 2e5 }");
    for (const std::string& partner : {resting, across}) {
        for (const double e : {0.7, 0.3}) {
            for (const std::string& keys : {fmt::format("[contact]\nrestitution = {}\n", e),
                                            fmt::format("[contact]\n[[contact.pair]]\nbetween = [\"ball\", "
                                                        "\"other\"]\nrestitution = {}\n",
                                                        e)}) {
                INFO(keys << partner);
                ContactRun run(falling_ball + partner + keys + timed(resolved));
                run.finish();
                const double a = run.at("ball").v.z(), b = run.at("other").v.z();
                CHECK(a + b == Approx(-approach).epsilon(1e-9));
                CHECK(a - b == Approx(e * approach).epsilon(1e-6));
            }
        }
        // Impulses of pairs lose more, by the first power of the step.
        const auto lack = [&](double step) {
            ContactRun run(falling_ball + partner + "[contact]\nrestitution = 0.7\n" +
                           timed(fmt::format("time_step = {}", step), 2e-3));
            run.finish();
            return 0.7 - (run.at("ball").v.z() - run.at("other").v.z()) / approach;
        };
        const double coarse = lack(4e-6), fine = lack(2e-6);
        CHECK(fine > 0.0);
        CHECK(fine < 0.01);
        CHECK(coarse / fine == Approx(2.0).margin(0.2));
    }
}

TEST_CASE("A capsule that lands flat or on an end leaves at the speed that restitution says",
          "[analyses][touch][bodies]") {
    const auto capsule = [](double tilt) {
        return thrown("ball",
                      fmt::format("at = [0, 0, {}]\nrotation_vector = [0, {}, 0]\nvelocity = [0, 0, -3]\n"
                                  "capsule = {{ from = [-0.3, 0, 0], to = [0.3, 0, 0], radius = 0.1, "
                                  "force = 2e5 }}",
                                  0.3 * std::sin(std::abs(tilt)) + 0.103,
                                  tilt));
    };
    SECTION("flat") {
        ContactRun run(capsule(0.0) + ground + "restitution = 0.6\n" + timed(resolved));
        run.finish();
        CHECK(run.at("ball").v.z() == Approx(0.6 * approach).epsilon(1e-6));
    }
    SECTION("on an end, where it is") {
        ContactRun run(capsule(0.5) + ground + "restitution = 0.6\n" + timed(resolved, 3e-3));
        run.finish();
        // By the impulse at the end, at this distance beside the centre of mass.
        const double arm = 0.3 * std::cos(0.5);
        const double impulse = 1.6 * approach / (1.0 / 2.0 + arm * arm / 0.02);
        CHECK(run.at("ball").v.z() == Approx(impulse / 2.0 - approach).epsilon(2e-3));
        CHECK(run.at("ball").omega.y() == Approx(-arm * impulse / 0.02).epsilon(2e-3));
    }
}

TEST_CASE("A ball bounces until it rests, as often as restitution says", "[analyses][touch][bodies]") {
    // Down to the skin, of 2 mm.
    const double e = 0.5, height = 0.048, g = 9.81;
    // Until all bounces are over: of the times between them, the sum.
    const double over = std::sqrt(2.0 * height / g) * (1.0 + 2.0 * e / (1.0 - e));
    ContactRun run("gravity = [0, 0, -9.81]\n" +
                   thrown("ball", "at = [0, 0, 0.15]\nsphere = { radius = 0.1, force = 2e5 }") + ground +
                   "restitution = 0.5\n" + timed("time_step = 2e-5", 0.4));
    REQUIRE(over == Approx(0.2968).margin(1e-4));
    double before = 1e300, last_free = 0.0;
    while (!run.is_finished()) {
        run.step();
        const LedgerRow row = run.ledger();
        const double total = row.kinetic_energy + row.contact_energy - row.external_work;
        CHECK(total < before + 1e-9);
        before = total;
        if (std::abs(run.at("ball").v.z()) > 0.01) last_free = run.time();
    }
    CHECK(last_free == Approx(over).margin(0.01));
    CHECK(run.at("ball").v.norm() < 1e-3);
}

TEST_CASE("Restitution never gives energy, however long steps are", "[analyses][touch][bodies]") {
    for (const double step : {1e-3, 2e-2}) {
        for (const double e : {0.9, 0.5, 0.02}) {
            INFO(step << " " << e);
            ContactRun run("gravity = [0, 0, -9.81]\n" + falling_ball + ground +
                           fmt::format("restitution = {}\n", e) +
                           timed(fmt::format("time_step = {}", step), 1.0));
            double before = 1e300;
            while (!run.is_finished()) {
                run.step();
                const LedgerRow row = run.ledger();
                const double total = row.kinetic_energy + row.contact_energy - row.external_work;
                CHECK(total < before + 1e-9 * 9.0);
                before = total;
            }
            CHECK(run.least_gap() > 0.0);
        }
    }
}

}  // namespace gxrod::test
