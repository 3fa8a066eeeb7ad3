// Runs of rods whose tendons rub in their paths.
#include <cmath>
#include <numbers>

#include "deck/decks.hpp"
#include "run/stepped_run.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// The rod of Till's ContinuumRobotExamples, after Rucker and Webster (2011), with friction.
namespace capstan {

constexpr double length = 0.5, radius = 1e-3, E = 200e9, a = 0.01506, mu = 0.3, most = 15.0;
constexpr double EI = E * std::numbers::pi * radius * radius * radius * radius / 4.0;
// The tendon turns with the sections, by κ = T a/EI, so that T′ = ∓μ T κ: 1/T changes by ±rate s.
constexpr double rate = mu * a / EI;

// As it is pulled, from no tension at all.
double pulled(double T, double s) { return 1.0 / (1.0 / T + rate * s); }
// As it is let go from the most: near its pulled end it slips, beyond `reach` it keeps what it had.
double reach_of_release(double T) { return (1.0 / T - 1.0 / most) / (2.0 * rate); }
double released(double T, double s) {
    return s < reach_of_release(T) ? 1.0 / (1.0 / T - rate * s) : pulled(most, s);
}

std::string wire(const std::string& tension, const std::string& rest, int elements = 8) {
    return R"deck([section.wire]
shape = { circle = { radius = 1e-3 } }
material = { E = 200e9, G = 80e9, density = 8000, shear_factor = 1 }
[rod.arm]
section = "wire"
line = { from = [0, 0, 0], to = [0.5, 0, 0] }
elements = )deck" +
           std::to_string(elements) + R"deck(
order = 4
y_axis = [0, 1, 0]
[[support]]
at = "arm.start"
fix = "all"
[tendon.t]
on = "arm"
offset = [0.01506, 0]
friction = 0.3
tension = )deck" +
           tension + "\n" + rest;
}

std::string statics(int steps) {
    return "[analysis]\nkind = \"static\"\nsteps = " + std::to_string(steps) +
           "\nnewton = { tolerance = 1e-12 }\n";
}

// Up to 15, down to 6 and up again, through values at quarters of a unit of time.
const std::string cycle = "\"t < 1 ? 15*t : t < 2 ? 15 - 9*(t - 1) : 6 + 9*(t - 2)\"";
std::string slowly(int steps) {
    return "[analysis]\nkind = \"quasi-static\"\nend_time = 3\nsteps = " + std::to_string(steps) +
           "\nnewton = { tolerance = 1e-12 }\n";
}

struct Moment {
    double time, tension, end_tension, length;
    Vec3 tip;
    LedgerRow ledger;
};

std::vector<Moment> run(const std::string& deck) {
    const Problem problem = read(deck);
    RunRequest request{problem};
    SteppedRun simulation(request);
    REQUIRE(simulation.start());
    std::vector<Moment> moments;
    const auto take = [&] {
        const TendonValues tendon = simulation.take_snapshot(false).tendons[0];
        moments.push_back({simulation.analysis().state().time,
                           tendon.tension,
                           tendon.end_tension,
                           tendon.length,
                           simulation.analysis().state().trial.back().r,
                           simulation.analysis().ledger_row()});
    };
    take();
    while (simulation.step()) take();
    INFO(simulation.summary().reason);
    REQUIRE(simulation.summary().reason.empty());
    return moments;
}

const Moment& at(const std::vector<Moment>& moments, double time) {
    for (const Moment& moment : moments) {
        if (std::abs(moment.time - time) < 1e-9) return moment;
    }
    FAIL("no step ends at " << time);
    return moments.front();
}

}  // namespace capstan
}  // namespace

TEST_CASE("A tendon that is pulled bends its rod less and less along it", "[analyses][tendon]") {
    using namespace capstan;
    for (const std::string element : {"objective", "simo"}) {
        for (const int steps : {1, 3}) {
            INFO(element << steps);
            const Moment end =
                run(replaced(wire("15", "", 16), "order = 4", "order = 4\nelement = \"" + element + "\"") +
                    statics(steps))
                    .back();
            CHECK(end.tension == 15.0);
            CHECK(end.end_tension == Approx(pulled(15.0, length)).epsilon(1e-9));
            CHECK(end.end_tension == Approx(12.3383814957345).epsilon(1e-9));
            // The equations of rod and tendon by an integration of their own.
            CHECK((end.tip - Vec3(0.4637152438753, 0.1620671155820, 0.0)).norm() < 1e-9);
        }
    }
}

TEST_CASE("Refinement brings the tension at the far end nearer by the order of the element",
          "[analyses][tendon]") {
    using namespace capstan;
    const auto error = [&](int elements, int order) {
        const std::string deck =
            replaced(wire("15", "", elements), "order = 4", "order = " + std::to_string(order));
        return std::abs(run(deck + statics(1)).back().end_tension - pulled(15.0, length));
    };
    for (const int order : {1, 2}) {
        INFO(order);
        CHECK(error(8, order) / error(16, order) > 0.85 * std::pow(2.0, order + 1));
    }
}

TEST_CASE("An arm whose tendon rubs has play: a loop with corners", "[analyses][tendon]") {
    using namespace capstan;
    for (const int steps : {12, 60}) {
        INFO(steps);
        const std::vector<Moment> moments = run(wire(cycle, slowly(steps), 8));
        for (const Moment& moment : moments) {
            INFO(moment.time);
            if (moment.time <= 1.0 && moment.time > 0.0) {
                CHECK(moment.end_tension == Approx(pulled(moment.tension, length)).epsilon(1e-7));
            } else if (moment.time <= 2.0 && moment.time > 0.0) {
                CHECK(moment.end_tension == Approx(released(moment.tension, length)).epsilon(1e-4));
            }
        }
        // The far end keeps its tension until the release has come there, at a pull of 10.48.
        CHECK(at(moments, 1.25).tension == Approx(12.75));
        CHECK(at(moments, 1.25).end_tension == Approx(at(moments, 1.0).end_tension).epsilon(1e-5));
        CHECK(at(moments, 2.0).end_tension < 0.6 * at(moments, 1.0).end_tension);
        // On the way up it keeps its tension again, and comes back to where the loop began.
        if (steps == 60)
            CHECK(at(moments, 2.05).end_tension == Approx(at(moments, 2.0).end_tension).epsilon(1e-5));
        CHECK(at(moments, 3.0).end_tension == Approx(at(moments, 1.0).end_tension).epsilon(1e-7));
        CHECK((at(moments, 3.0).tip - at(moments, 1.0).tip).norm() < 1e-8);
    }
}

TEST_CASE("The tip of an arm that is let go is where its tendon's tensions bend it", "[analyses][tendon]") {
    using namespace capstan;
    // Two integrations of their own, of the part that slips and of the part that sticks.
    const std::vector<std::pair<double, Vec3>> known{{12.0, {0.4697392937511, 0.1467001749572, 0.0}},
                                                     {8.0, {0.4866918344948, 0.0984275905269, 0.0}},
                                                     {6.0, {0.4926577389190, 0.0735177171583, 0.0}}};
    for (const auto& [pull, tip] : known) {
        INFO(pull);
        const std::string tension = "\"t < 1 ? 15*t : 15 - (15 - " + std::to_string(pull) + ")*(t - 1)/2\"";
        const std::vector<Moment> moments = run(wire(tension, slowly(12), 10));
        // Where slip ends within an element the tension has a corner.
        CHECK((moments.back().tip - tip).norm() < (reach_of_release(pull) < length ? 2e-5 : 1e-9));
    }
}

TEST_CASE("A tendon can be pulled at either end of its rod", "[analyses][tendon]") {
    using namespace capstan;
    const Moment end = run(wire("15", "pulled_at = \"to\"\n") + statics(2)).back();
    CHECK(end.tension == 15.0);
    CHECK(end.end_tension == Approx(pulled(15.0, length)).epsilon(1e-8));
    // It bends the tip more than the root.
    const Moment near = run(wire("15", "") + statics(2)).back();
    CHECK(end.tip.y() < near.tip.y());
}

// A rod bent to an arc, much stiffer than the tendon can bend: what is lost is by the angle of the arc.
// Elements of order 1 know directions at both ends exactly, others from the slopes at their force points.
TEST_CASE("A tendon round an arc loses tension by the angle alone", "[analyses][tendon]") {
    using namespace capstan;
    const auto find_angle = [](int order, int elements, double offset) {
        const std::string deck = R"deck([section.s]
stiffness = { EA = 1e12, GAy = 1e12, GAz = 1e12, GJ = 1e12, EIy = 1e12, EIz = 1e12 }
[rod.r]
section = "s"
arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [2, 0, 0], angle = "4*pi/3" }
elements = )deck" + std::to_string(elements) +
                                 "\norder = " + std::to_string(order) + R"deck(
y_axis = [0, 0, 1]
[[support]]
at = "r.start"
fix = "all"
[tendon.t]
on = "r"
offset = [0.0, )deck" + std::to_string(offset) +
                                 "]\ntension = 7\nfriction = 0.25\n" + statics(1);
        return -std::log(run(deck).back().end_tension / 7.0) / 0.25;
    };
    constexpr double exact = 4.0 * std::numbers::pi / 3.0;
    for (const double offset : {0.1, -0.1}) {
        INFO(offset);
        CHECK(find_angle(1, 8, offset) == Approx(exact).epsilon(1e-9));
        CHECK(find_angle(4, 8, offset) == Approx(exact).epsilon(1e-6));
        const double coarse = find_angle(2, 8, offset) - exact, fine = find_angle(2, 16, offset) - exact;
        CHECK(coarse / fine > 3.5);
        CHECK(std::abs(fine) < 1e-3 * exact);
    }
}

TEST_CASE("The books of an arm whose tendon rubs close", "[analyses][tendon]") {
    using namespace capstan;
    const auto error = [](const std::vector<Moment>& moments) {
        double largest = 0.0;
        for (const Moment& moment : moments)
            largest = std::max(largest, std::abs(moment.ledger.energy_error));
        return largest;
    };
    // Curvatures are proportional to tensions, so that the mean of both ends is exact, in any step.
    const std::vector<Moment> fine = run(wire(cycle, slowly(60)));
    CHECK(error(fine) < 1e-10 * fine.back().ledger.strain_energy);
    // What the actuator gives beyond that is lost by friction: once around from 15 to 6 and back, by the area
    // of the loop. The rod is where it was.
    double given = 0.0;
    for (std::size_t i = 1; i < fine.size(); ++i) {
        if (fine[i].time > 1.0 + 1e-9)
            given -= 0.5 * (fine[i].tension + fine[i - 1].tension) * (fine[i].length - fine[i - 1].length);
    }
    CHECK(std::abs(at(fine, 3.0).ledger.external_work - at(fine, 1.0).ledger.external_work) < 1e-6);
    CHECK(given > 1e-3);
}

TEST_CASE("Steps that are cut and stages of a scheme leave the tension of a tendon alone",
          "[analyses][tendon]") {
    using namespace capstan;
    // So slow that inertia hardly matters: dynamics go through the same equilibria.
    const auto swing = [](const std::string& scheme) {
        const std::string slow = replaced(cycle, "15*t", "15*t*t*(3 - 2*t)");
        return replaced(wire(slow, "", 4), "order = 4", "order = 2") +
               "[analysis]\nkind = \"dynamic\"\nend_time = 1.25\nsteps = 125\nintegrator = \"" + scheme +
               "\"\n";
    };
    const Moment other = run(swing("generalized-alpha")).back();
    const Moment end = run(swing("sdirk-4")).back();
    CHECK(end.end_tension == Approx(other.end_tension).epsilon(2e-3));
    CHECK((end.tip - other.tip).norm() < 1e-3);
    // Steps that Newton's method cannot take at once are cut, to the same end.
    const auto patience = [](const std::string& iterations) {
        return replaced(wire(cycle, slowly(3), 8), "tolerance = 1e-12", "tolerance = 1e-12, " + iterations);
    };
    const Moment cut = run(patience("max_iterations = 14")).back();
    const Moment whole = run(patience("max_iterations = 40")).back();
    CHECK(cut.end_tension == Approx(whole.end_tension).epsilon(1e-9));
}

TEST_CASE("A tendon that sticks and stretches takes part of what the arm is bent", "[analyses][tendon]") {
    using namespace capstan;
    // It bends the arm towards the tendon, whose turning grows, so that it sticks.
    const std::string turned = "[[load]]\nat = \"arm.end\"\nmoment = [0, 0, \"t < 1 ? 0 : 0.05*(t - 1)\"]\n";
    const std::string tension = "\"t < 1 ? 5*t : 5\"";
    const auto run_with = [&](const std::string& more) {
        return run(wire(tension, more + turned + slowly(30), 8));
    };
    const std::vector<Moment> soft = run_with(""), stiff = run_with("stiffness = 10\n");
    CHECK(soft.back().end_tension == Approx(at(soft, 1.0).end_tension).epsilon(1e-6));
    const double stretch = (stiff.back().length - at(stiff, 1.0).length) / length;
    REQUIRE(stretch < -1e-3);
    CHECK(stiff.back().end_tension - at(stiff, 1.0).end_tension == Approx(10.0 * stretch).epsilon(0.05));
}

TEST_CASE("Every tangent and kind of statics, a path among them, takes a tendon that rubs",
          "[analyses][tendon]") {
    using namespace capstan;
    for (const std::string analysis :
         {"[analysis]\nkind = \"static\"\nsteps = 20\nnewton = { tangent = \"mixed\" }\n",
          "[analysis]\nkind = \"static\"\nsteps = 2\nnewton = { tangent = \"difference\" }\n",
          "[analysis]\nkind = \"path\"\nuntil = { t = 1, steps = 50 }\n"}) {
        INFO(analysis);
        const Moment end = run(wire("\"15*t\"", analysis)).back();
        CHECK(end.end_tension == Approx(pulled(15.0, length)).epsilon(1e-6));
    }
}

TEST_CASE("Newton's method converges quadratically though a tendon rubs", "[analyses][tendon]") {
    using namespace capstan;
    const auto count = [](const std::string& deck) {
        const Problem problem = read(deck);
        SteppedRun simulation(RunRequest{problem});
        REQUIRE(simulation.start());
        while (simulation.step()) {
        }
        return simulation.summary().totals.newton_iterations;
    };
    const std::string deck = wire("15", statics(4));
    CHECK(count(deck) <= count(replaced(deck, "friction = 0.3\n", "")) + 8);
}

}  // namespace gxrod::test
