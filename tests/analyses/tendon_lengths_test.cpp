// Runs of rods whose tendons winches draw in.
#include <cmath>
#include <numbers>

#include "deck/decks.hpp"
#include "run/stepped_run.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// The rod of Till's ContinuumRobotExamples, after Rucker and Webster (2011).
constexpr double length = 0.5, radius = 1e-3, modulus = 200e9, offset = 0.01506;
constexpr double EA = modulus * std::numbers::pi * radius * radius;
constexpr double EI = modulus * std::numbers::pi * radius * radius * radius * radius / 4.0;
// How a tendon along the rod at an offset a shortens by its tension: N = −T and M = T a of the rod.
constexpr double compliance = length * (1.0 / EA + offset * offset / EI);

std::string wire(int elements, const std::string& rest) {
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
)deck" + rest;
}

std::string parallel(const std::string& winch) {
    return wire(4, "[tendon.t]\non = \"arm\"\noffset = [0.01506, 0]\n" + winch + "\n");
}

const std::string statics = "[analysis]\nkind = \"static\"\nsteps = 4\nnewton = { tolerance = 1e-12 }\n";

struct End {
    Vec3 tip;
    TendonValues tendon;
    LedgerRow ledger;
    double energy_error = 0.0, least_tension = 0.0, work = 0.0;  // −∫ T dℓ by the trapezoidal rule
};

End run(const std::string& deck) {
    const Problem problem = read(deck);
    RunRequest request{problem};
    SteppedRun simulation(request);
    REQUIRE(simulation.start());
    End end;
    end.tendon = simulation.take_snapshot(false).tendons[0];
    while (simulation.step()) {
        const TendonValues now = simulation.take_snapshot(false).tendons[0];
        end.energy_error =
            std::max(end.energy_error, std::abs(simulation.analysis().ledger_row().energy_error));
        end.least_tension = std::min(end.least_tension, now.tension);
        end.work -= 0.5 * (now.tension + end.tendon.tension) * (now.length - end.tendon.length);
        end.tendon = now;
    }
    INFO(simulation.summary().reason);
    REQUIRE(simulation.summary().reason.empty());
    end.ledger = simulation.analysis().ledger_row();
    end.tip = simulation.analysis().state().trial.back().r;
    return end;
}

}  // namespace

TEST_CASE("A tendon that is drawn in has the tension whose tendon is as long", "[analyses][tendon]") {
    // F14a: exact; a value without t grows, as a shortening or a length.
    for (const std::string winch :
         {"shortening = 0.010841010836", "shortening = \"0.010841010836*t\"", "length = 0.489158989164"}) {
        const End end = run(parallel(winch) + statics);
        INFO(winch);
        CHECK(end.tendon.tension == Approx(15.0).epsilon(1e-9));
        CHECK(end.tendon.tension == Approx(0.010841010836 / compliance).epsilon(1e-10));
        CHECK(end.tendon.length == Approx(0.489158989164).epsilon(1e-13));
        CHECK((end.tip - Vec3(0.4580018538285, 0.1721480197526, 0.0)).norm() < 1e-10);
        CHECK(end.ledger.external_work == Approx(0.5 * 15.0 * 0.010841010836).epsilon(1e-8));
        CHECK(end.energy_error < 1e-9 * end.ledger.strain_energy);
    }
    // F14c, a helix of one turn, and F14e, with a force at the tip: 12 digits by two formulations.
    const End helix =
        run(wire(16,
                 "[tendon.t]\non = \"arm\"\noffset = [\"0.01506*cos(4*pi*s)\", \"0.01506*sin(4*pi*s)\"]\n"
                 "length = 0.497940566956\n") +
            statics);
    CHECK(helix.tendon.tension == Approx(15.0).epsilon(1e-7));
    CHECK((helix.tip - Vec3(0.493268788588, 0.000073403983, 0.058159618204)).norm() < 1e-9);
    const End pushed = run(parallel("length = 0.489177405797") +
                           "[[load]]\nat = \"arm.end\"\nforce = [0, 0, 0.3]\n" + statics);
    CHECK(pushed.tendon.tension == Approx(15.0).epsilon(1e-7));
    CHECK((pushed.tip - Vec3(0.451627438179, 0.168713651271, 0.076820797768)).norm() < 1e-9);
}

TEST_CASE("Both elements, every tangent and every kind of statics find the tension", "[analyses][tendon]") {
    const std::string analysis =
        GENERATE(as<std::string>{},
                 "[analysis]\nkind = \"static\"\nsteps = 20\nnewton = { tangent = \"mixed\" }\n",
                 "[analysis]\nkind = \"static\"\nsteps = 1\nnewton = { tangent = \"difference\" }\n",
                 "[analysis]\nkind = \"quasi-static\"\nend_time = 1\nsteps = 20\n",
                 "[analysis]\nkind = \"path\"\nuntil = { t = 1, steps = 50 }\n");
    for (const std::string element : {"objective", "simo"}) {
        INFO(analysis << element);
        const End end = run(replaced(parallel("shortening = \"0.005*t\""),
                                     "order = 4",
                                     "order = 4\nelement = \"" + element + "\"") +
                            analysis);
        CHECK(end.tendon.tension == Approx(0.005 / compliance).epsilon(1e-6));
    }
}

TEST_CASE("A tendon that stretches shares what is drawn in with its rod", "[analyses][tendon]") {
    const End end = run(parallel("shortening = 0.01\nstiffness = 5e3") + statics);
    const double tension = 0.01 / (compliance + length / 5e3);
    CHECK(end.tendon.tension == Approx(tension).epsilon(1e-10));
    CHECK(end.tendon.length == Approx(length - tension * compliance).epsilon(1e-12));
    // Of the rod and the tendon.
    CHECK(end.ledger.strain_energy == Approx(0.5 * tension * 0.01).epsilon(1e-9));
    CHECK(end.energy_error < 1e-9 * end.ledger.strain_energy);
}

TEST_CASE("A tendon that is let out hangs loose and leaves its rod straight", "[analyses][tendon]") {
    for (const std::string more : {"", "\nstiffness = 5e3"}) {
        const End out = run(parallel("shortening = \"-0.01*t\"" + more) + statics);
        CHECK(out.tendon.tension == 0.0);
        CHECK(out.tendon.length == Approx(length).epsilon(1e-14));
        CHECK((out.tip - Vec3(0.5, 0.0, 0.0)).norm() < 1e-14);
        // Taut first.
        const End back = run(parallel("shortening = \"0.01*sin(1.5*pi*t)\"" + more) +
                             replaced(statics, "steps = 4", "steps = 10"));
        CHECK(back.tendon.tension == 0.0);
        CHECK((back.tip - Vec3(0.5, 0.0, 0.0)).norm() < 1e-10);
        CHECK(back.work < 1e-3);
    }
    const End pushes = run(parallel("shortening = \"-0.01*t\"\nslack = false") + statics);
    CHECK(pushes.tendon.tension == Approx(-0.01 / compliance).epsilon(1e-10));
    CHECK(pushes.tip[1] < -0.1);
}

TEST_CASE("A winch lets go in stages that do not name its tendon", "[analyses][tendon]") {
    const End end = run(parallel("shortening = 0.001\nstages = [\"pull\"]") +
                        "[[stage]]\nname = \"pull\"\nkind = \"static\"\nsteps = 4\n"
                        "[[stage]]\nname = \"free\"\nkind = \"static\"\nsteps = 4\n");
    CHECK(end.tendon.tension == 0.0);
    CHECK((end.tip - Vec3(0.5, 0.0, 0.0)).norm() < 1e-8);
    const End held = run(parallel("shortening = 0.001") +
                         "[[stage]]\nname = \"pull\"\nkind = \"static\"\nsteps = 4\n"
                         "[[stage]]\nname = \"same\"\nkind = \"static\"\nsteps = 4\n");
    CHECK(held.tendon.tension == Approx(0.001 / compliance).epsilon(1e-8));
}

namespace {

// A soft cantilever that swings as a winch draws its tendon in and lets it out again.
std::string swinging(const std::string& winch, const std::string& scheme, const std::string& step) {
    return R"deck([section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
order = 2
[[support]]
at = "r.start"
fix = "all"
[tendon.t]
on = "r"
offset = ["0.05*cos(s)", 0.05]
)deck" + winch +
           "\n[analysis]\nkind = \"dynamic\"\nend_time = 0.5\nintegrator = \"" + scheme +
           "\"\ntime_step = " + step + "\nnewton = { tolerance = 1e-12 }\n";
}

}  // namespace

TEST_CASE("The work of a winch closes the books in dynamics", "[analyses][tendon]") {
    for (const std::string winch : {"shortening = \"0.02*sin(3*t)^2\"\nslack = false",
                                    "shortening = \"0.02*sin(3*t)^2\"\nslack = false\nstiffness = 3e3"}) {
        for (const std::string scheme :
             {"newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4"}) {
            INFO(winch << scheme);
            const End coarse = run(swinging(winch, scheme, "0.02"));
            const End fine = run(swinging(winch, scheme, "0.01"));
            CHECK(fine.energy_error < coarse.energy_error / 3.0);
            CHECK(fine.energy_error < 1e-2 * fine.ledger.strain_energy);
        }
    }
    const End end =
        run(swinging("shortening = \"0.02*sin(3*t)^2\"\nslack = false", "newmark-ibrahimbegovic", "0.01"));
    CHECK(end.ledger.external_work == Approx(end.work).epsilon(1e-10));
    CHECK(std::abs(end.work) > 1e-3);
}

TEST_CASE("An explicit scheme keeps a tendon as long as it is prescribed", "[analyses][tendon]") {
    const auto deck = [](const std::string& scheme, const std::string& step) {
        return replaced(swinging("shortening = \"0.02*sin(3*t)^2\"\nslack = false", scheme, step),
                        "end_time = 0.5",
                        "end_time = 0.1");
    };
    const End end = run(replaced(deck("runge-kutta-4", "1e-3"), "newton = { tolerance = 1e-12 }\n", ""));
    const End other = run(deck("sdirk-4", "2e-3"));
    CHECK(end.tendon.length == Approx(other.tendon.length).epsilon(1e-10));
    CHECK(end.tendon.tension == Approx(other.tendon.tension).epsilon(1e-3));
    CHECK((end.tip - other.tip).norm() < 1e-6);
}

TEST_CASE("A tendon that swings loose never pushes", "[analyses][tendon]") {
    for (const std::string more : {"", "\nstiffness = 3e3"}) {
        for (const std::string scheme : {"newmark-simplified", "generalized-alpha", "sdirk-4"}) {
            INFO(more << scheme);
            const End end = run(swinging("shortening = \"0.02*sin(6*t)^2\"" + more, scheme, "0.01"));
            CHECK(end.least_tension >= 0.0);
            CHECK(end.energy_error < 0.2 * end.work);
        }
    }
}

TEST_CASE("Sections bear the tension of a tendon that is drawn in", "[analyses][tendon]") {
    const Problem problem = read(parallel("shortening = 0.01") + statics);
    SteppedRun simulation(RunRequest{problem});
    REQUIRE(simulation.start());
    while (simulation.step()) {
    }
    // The section as a whole, the tendon included, is free of force; the rod alone is not.
    const Snapshot snapshot = simulation.take_snapshot(true);
    const SectionValues& first = snapshot.elements.front();
    CHECK(first.force.norm() < 1e-9 * snapshot.tendons[0].tension);
    CHECK(first.moment.norm() < 1e-9 * snapshot.tendons[0].tension * offset);
    CHECK(first.curvature.norm() == Approx(snapshot.tendons[0].tension * offset / EI));
}

}  // namespace gxrod::test
