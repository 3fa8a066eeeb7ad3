// Rods that touch, against exact solutions.
#include "analyses/contact/contact_run.hpp"

namespace gxrod::test {
namespace {

using Run = ContactRun;

const std::string rubber = R"(
[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e9, nu = 0.3 }
)";

// On the ground, from gaps in the skin: rods of a length of 1 and a radius of 0.05.
std::string slider(const std::string& more, double friction, double density = 1000.0) {
    return fmt::format(R"(
gravity = [0, 0, -9.81]
[section.s]
shape = {{ circle = {{ radius = 0.05 }} }}
material = {{ E = 1e9, nu = 0.3, density = {} }}
[obstacle.floor]
plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }}
friction = {}
)",
                       density,
                       friction) +
           rod("a", "0, 0, 0.050979", "1, 0, 0.050979", 4) + more;
}

// A rod across two that are held, in equilibrium in their skin but for friction.
std::string on_two_rods(double angle, double friction, const std::string& more) {
    constexpr double gravity = 9.81;
    std::string text = fmt::format(R"(
gravity = [{}, 0, {}]
[section.s]
shape = {{ circle = {{ radius = 0.02 }} }}
material = {{ E = 2e9, nu = 0.3, density = 1000 }}
[rod.top]
section = "s"
line = {{ from = [-0.5, 0, 0.0403917], to = [0.5, 0, 0.0403917] }}
elements = 4
order = 2
[contact]
friction = {}
{})",
                                   gravity * std::sin(angle),
                                   -gravity * std::cos(angle),
                                   friction,
                                   more);
    for (const double x : {-0.25, 0.25})
        text += fmt::format(R"(
[rod.r{0}]
section = "s"
line = {{ from = [{1}, -0.1, 0], to = [{1}, 0.1, 0] }}
elements = 2
order = 2
[[support]]
at = "r{0}.start"
fix = "all"
[[support]]
at = "r{0}.end"
fix = "all"
)",
                            x < 0.0 ? 1 : 2,
                            x);
    return text;
}

}  // namespace

TEST_CASE("C1c: a cantilever on a cylinder is pushed as the elastica is", "[analyses][touch]") {
    Run run(rubber + rod("a", "0, 0, 0.0005", "1, 0, 0.0005", 20) + R"(
[[support]]
at = "a.start"
fix = ["x", "y", "rotation"]
move = { z = "-t*0.3005" }
[obstacle.c]
cylinder = { from = [0.8, -1, -0.06], to = [0.8, 1, -0.06], radius = 0.05 }
[analysis]
kind = "static"
steps = 3
)");
    run.finish();
    const ObstacleValues found = run.obstacle();
    // The gap acts like more of the drop: 30 g of the force.
    const double gap = found.least_gap;
    CHECK(gap > 0.0);
    CHECK(found.force.norm() == Approx(12.429723539 + 30.0 * gap).epsilon(3e-4));
    CHECK(found.force.x() / found.force.z() == Approx(-6.433909720 / 10.634981568).epsilon(1e-3));
    CHECK(run.reaction("a.start").head<3>().isApprox(found.force, 1e-6));
    CHECK(run.least_gap() > 0.0);
}

TEST_CASE("C1a: two crossing cantilevers push each other as the elastica does", "[analyses][touch]") {
    Run run(rubber + rod("a", "0, 0, 0", "1, 0, 0", 20) +
            rod("b", "0.8, -0.6, 0.0205", "0.8, 0.4, 0.0205", 20) + R"(
[[support]]
at = "a.start"
fix = "all"
[[support]]
at = "b.start"
fix = ["x", "y", "rotation"]
move = { z = "-0.3005*t" }
[contact]
[analysis]
kind = "static"
steps = 6
)");
    run.finish();
    const Vec3 force = -run.reaction("a.start").head<3>();
    const double gap = 1.5e-4;  // about: 19 g of the force
    CHECK(force.norm() == Approx(8.1004620411 - 19.0 * -gap).epsilon(1e-3));
    CHECK(run.at("a.end").r.z() == Approx(-0.259214832).epsilon(1e-3));
    CHECK(run.at("b.end").r.x() == Approx(0.865466068).epsilon(1e-3));
    CHECK(run.least_gap() > 0.0);
}

TEST_CASE("Rods that meet many others in a step need no shorter steps", "[analyses][touch]") {
    // Six rods fall on six others across them, all of which they meet within two steps, at heights that
    // differ by a skin or two.
    std::string deck = R"(
[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e8, nu = 0.3, density = 1000 }
[contact]
self = false
friction = 0.2
[analysis]
kind = "dynamic"
end_time = 0.03
time_step = 1e-3
)";
    const auto at = [](double x, double y, double z) { return fmt::format("{}, {}, {}", x, y, z); };
    for (int i = 0; i < 6; ++i) {
        const std::string low = fmt::format("low{}", i), high = fmt::format("high{}", i);
        const double place = 0.1 * i, bottom = -3e-4 * ((5 * i) % 6), top = 0.0205 + 2e-4 * ((7 * i) % 6);
        deck += rod(low.c_str(), at(place, -0.1, bottom).c_str(), at(place, 0.6, bottom).c_str(), 7);
        deck += rod(high.c_str(), at(-0.1, place, top).c_str(), at(0.6, place, top).c_str(), 7);
        deck += fmt::format("[[initial]]\non = \"{}\"\nvelocity = [0, 0, -2]\n", high);
        for (const char* end : {"start", "end"})
            deck += fmt::format("[[support]]\nat = \"{}.{}\"\nfix = \"all\"\n", low, end);
    }
    Run run(deck);
    run.finish();
    CHECK(run.rejected() == 0);
    CHECK(run.least_gap() > 0.0);
    CHECK(run.ledger().contact_loss > 0.0);
}

TEST_CASE("C5c: friction stops a rod after the distance of a body that slides", "[analyses][touch]") {
    Run run(slider(R"(
[[initial]]
on = "a"
velocity = [2, 0, 0]
[analysis]
kind = "dynamic"
end_time = 1.0
time_step = 0.005
)",
                   0.3));
    run.finish();
    CHECK(run.at("a.end").r.x() == Approx(1.0 + 0.6795786612).epsilon(3e-6));
    CHECK(run.at("a.end").v.norm() < 1e-3);
    const LedgerRow ledger = run.ledger();
    CHECK(ledger.contact_loss == Approx(0.5 * 4.0 * 1000.0 * M_PI * 0.05 * 0.05).epsilon(1e-5));
    CHECK(std::abs(ledger.energy_error) < 1e-7);
    CHECK(run.rejected() == 0);
}

TEST_CASE("C5b: a rod that slides across begins to roll", "[analyses][touch]") {
    Run run(slider(R"(
[[initial]]
on = "a"
velocity = [0, 2, 0]
[analysis]
kind = "dynamic"
end_time = 0.4
time_step = 0.002
)",
                   0.3));
    run.finish();
    // From t* on with v* = 4/3.
    constexpr double start = 0.2265262204, way = 0.3775437007, speed = 4.0 / 3.0;
    CHECK(run.at("a.start").v.y() == Approx(speed).epsilon(2e-3));
    CHECK(run.at("a.start").omega.x() == Approx(-speed / 0.05).epsilon(2e-3));
    CHECK(run.at("a.start").r.y() == Approx(way + speed * (0.4 - start)).epsilon(2e-3));
    CHECK(run.ledger().contact_loss == Approx(0.6666666667 * 1000.0 * M_PI * 0.05 * 0.05).epsilon(3e-3));
}

TEST_CASE("C5e: on an incline a rod holds below the cone, and slides beyond", "[analyses][touch]") {
    const auto incline = [](double friction, double end) {
        return slider(fmt::format("[analysis]\nkind = \"dynamic\"\nend_time = {}\ntime_step = 0.01\n", end),
                      friction);
    };
    const std::string tilted =
        fmt::format("gravity = [{:.15g}, 0, {:.15g}]", 9.81 * std::sin(0.25), -9.81 * std::cos(0.25));
    SECTION("holds") {
        Run run(replaced(incline(0.3, 100.0), "gravity = [0, 0, -9.81]", tilted));
        run.finish();
        CHECK(std::abs(run.at("a.start").r.x()) < 1e-5);  // of a skin of 1e-3
    }
    SECTION("slides") {
        Run run(replaced(incline(0.2, 1.0), "gravity = [0, 0, -9.81]", tilted));
        run.finish();
        CHECK(run.at("a.start").r.x() == Approx(0.5 * 0.5260266689).epsilon(1e-4));
    }
}

TEST_CASE("A rod on two rods that lie on an incline holds below the cone, and slides beyond",
          "[analyses][touch]") {
    const double angle = 0.25, gravity = 9.81;
    const auto deck = [&](double friction) {
        return on_two_rods(
            angle, friction, "[analysis]\nkind = \"dynamic\"\nend_time = 0.4\ntime_step = 0.002\n");
    };
    SECTION("holds") {
        Run run(deck(0.3));
        run.finish();
        // It settles first, for which friction allows about a skin.
        CHECK(std::abs((run.at("top.start").r[0] + 0.5)) < 4e-4);
        CHECK(std::abs(run.ledger().energy_error) < 1e-6);
    }
    SECTION("slides") {
        Run run(deck(0.2));
        run.finish();
        const double acceleration = gravity * (std::sin(angle) - 0.2 * std::cos(angle));
        const double way = 0.5 * acceleration * 0.16, mass = M_PI * 0.02 * 0.02 * 1000.0;
        CHECK((run.at("top.start").r[0] + 0.5) == Approx(way).epsilon(0.005));
        CHECK(run.ledger().contact_loss ==
              Approx(0.2 * mass * gravity * std::cos(angle) * way).epsilon(0.05));
    }
}

TEST_CASE("Without friction a rod slides along others as if nothing held it", "[analyses][touch]") {
    const double mass = M_PI * 0.02 * 0.02 * 1000.0;
    // Half a radius a step.
    Run run(on_two_rods(0.0, 0.0, R"(
[[initial]]
on = "top"
velocity = [5, 0, 0]
[analysis]
kind = "dynamic"
end_time = 0.04
time_step = 0.002
)"));
    double before = 0.0;
    while (!run.is_finished()) {
        run.step();
        const double loss = run.ledger().contact_loss;
        CHECK(loss > before - 1e-9 * run.ledger().kinetic_energy);
        before = loss;
    }
    const double way = run.at("top.start").r[0] + 0.5;
    CHECK(way == Approx(0.2).epsilon(1e-3));
    // As a part of what its weight times the way would be with a friction of 1.
    CHECK(before / (mass * 9.81 * way) < 2e-3);
}

TEST_CASE("Without friction the end of a rod slides along another without bumps", "[analyses][touch]") {
    // Pressed with 10 kN, over the borders of five pieces.
    std::string deck = R"(
[section.s]
shape = { circle = { radius = 0.05 } }
material = { E = 1e10, nu = 0.3, density = 1000 }
[contact]
[[initial]]
on = "post"
velocity = [1, 0, 0]
[[load]]
at = "post.end"
force = [0, 0, -1e4]
[analysis]
kind = "dynamic"
gamma = 0.6
beta = 0.3
time_step = 1e-3
end_time = 0.5
)" + rod("beam", "0, 0, 0", "1, 0, 0", 10, 1) +
                       rod("post", "0.23, 0, 0.1005", "0.23, 0, 0.6005", 1, 1);
    for (int node = 0; node <= 10; ++node)
        deck +=
            fmt::format("[[support]]\nat = \"beam@{}\"\nfix = [\"position\", \"rotation\"]\n", 0.1 * node);
    for (const char* end : {"start", "end"})
        deck += fmt::format("[[support]]\nat = \"post.{}\"\nfix = [\"y\", \"rotation\"]\n", end);
    Run run(deck);
    run.finish();
    CHECK(run.at("post.start").v.x() == Approx(1.0).epsilon(1e-5));
    CHECK(run.at("post.start").r.x() == Approx(0.73).epsilon(1e-5));
}

TEST_CASE("C5a: without dissipation a rod bounces as high as it fell from, at any step",
          "[analyses][touch]") {
    constexpr double fall = 0.5 * 9.81;  // per mass
    const double mass = 1000.0 * M_PI * 0.05 * 0.05;
    for (const double step : {2e-3, 1e-2, 5e-2}) {
        INFO(step);
        Run run(replaced(slider(fmt::format(R"(
[contact]
dissipation = 0
self = false
[analysis]
kind = "dynamic"
end_time = 6.7
time_step = {}
)",
                                            step),
                                0.0),
                         "0.050979], to = [1, 0, 0.050979]",
                         "0.55], to = [1, 0, 0.55]"));
        int bounces = 0;
        double before = 0.0, highest = 0.0;
        while (!run.is_finished()) {
            run.step();
            const LedgerRow row = run.ledger();
            const double total =
                row.kinetic_energy + row.strain_energy + row.contact_energy - row.external_work;
            CHECK(std::abs(total) < 1e-6 * mass * fall);
            CHECK(std::abs(row.contact_loss) < 1e-9 * mass * fall);
            const double speed = run.at("a.end").v.z();
            if (before < 0.0 && speed > 0.0) ++bounces;
            if (bounces > 0) highest = std::max(highest, run.at("a.end").r.z());
            before = speed;
        }
        // 10 rebounds at 0.319 s and every 0.639 s from there on; a step apart from the top at most.
        CHECK(bounces == 10);
        CHECK(highest < 0.55 + 1e-6);
        CHECK(highest > 0.55 - 0.5 * 9.81 * step * step / 4.0 - 1e-6);
        CHECK(run.least_gap() > 0.0);
    }
}

TEST_CASE("With dissipation contact with a plane never gives energy", "[analyses][touch]") {
    for (const double step : {2e-3, 5e-2}) {
        Run run(replaced(
            slider(fmt::format("[analysis]\nkind = \"dynamic\"\nend_time = 2\ntime_step = {}\n", step), 0.2),
            "0.050979], to = [1, 0, 0.050979]",
            "0.15], to = [1, 0, 0.25]"));
        double before = 0.0;
        while (!run.is_finished()) {
            run.step();
            const double loss = run.ledger().contact_loss;
            CHECK(loss >= before - 1e-9);
            before = loss;
        }
        CHECK(before > 1.0);
        CHECK(run.least_gap() > 0.0);
    }
}

TEST_CASE("Rods that collide in space keep their momenta", "[analyses][touch]") {
    Run run(replaced(rubber, "nu = 0.3", "nu = 0.3, density = 1000") + rod("a", "0, 0, 0", "1, 0, 0", 6) +
            rod("b", "0.5, -0.4, 0.1", "0.6, 0.6, 0.1", 6) + R"(
[[initial]]
on = "b"
velocity = [0, 0, -5]
[contact]
self = false
[analysis]
kind = "dynamic"
end_time = 0.06
time_step = 5e-4
)");
    const LedgerRow start = run.ledger();
    run.finish();
    const LedgerRow end = run.ledger();
    CHECK((end.linear_momentum - start.linear_momentum).norm() < 1e-9 * start.linear_momentum.norm());
    CHECK(run.at("a.end").v.norm() > 0.1);
    CHECK(end.contact_loss > 0.0);
    CHECK(end.kinetic_energy + end.strain_energy + end.contact_energy < start.kinetic_energy);
    CHECK(run.least_gap() > 0.0);
}

TEST_CASE("A moved obstacle pushes, and does work", "[analyses][touch]") {
    Run run(rubber + rod("a", "0, 0, 0", "1, 0, 0", 10) + R"(
[[support]]
at = "a.start"
fix = "all"
[obstacle.ball]
sphere = { centre = [0.9, 0, -0.0605], radius = 0.05 }
move = { z = "0.1*t" }
[analysis]
kind = "static"
steps = 40
)");
    run.finish();
    const ObstacleValues found = run.obstacle();
    CHECK(found.force.z() < 0.0);
    CHECK(run.reaction("a.start").head<3>().isApprox(found.force, 1e-6));
    const LedgerRow ledger = run.ledger();
    // Linear in small displacements: ½ F δ.
    CHECK(ledger.strain_energy == Approx(0.5 * -found.force.z() * 0.0995).epsilon(0.02));
    CHECK(ledger.external_work == Approx(ledger.strain_energy + ledger.contact_energy).epsilon(5e-3));
    CHECK(ledger.contact_loss == Approx(0.0).margin(1e-9));
}

}  // namespace gxrod::test
