#include "deck/drives/chamber_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "analyses/ledger.hpp"
#include "deck/decks.hpp"
#include "face/simulation.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// A soft arm of radius 15 mm and a chamber at its side; it has no weight.
std::string make_arm(const std::string& chamber, const std::string& analysis = "kind = \"static\"\n") {
    return R"deck([section.soft]
shape = { circle = { radius = 0.015 } }
material = { E = 1e6, nu = 0.5, density = 1000 }
[rod.arm]
section = "soft"
line = { from = [0, 0, 0], to = [0.2, 0, 0] }
elements = 5
order = 4
y_axis = [0, 1, 0]
[[support]]
at = "arm.start"
fix = "all"
)deck" + chamber +
           "[[history]]\nname = \"chamber\"\nat = \"left\"\nquantities = [\"tendon_length\", "
           "\"tendon_tension\"]\n[[history]]\nname = \"tip\"\nat = \"arm.end\"\nquantities = [\"position\", "
           "\"rotation_vector\"]\n[analysis]\n" +
           analysis;
}

const std::string left = "[chamber.left]\non = \"arm\"\noffset = [0, 0.008]\narea = 1.5e-4\npressure = 5e4\n";

constexpr double length = 0.2, area = 1.5e-4, offset = 0.008, pressure = 5e4, modulus = 1e6;
constexpr double cross_section = std::numbers::pi * 0.015 * 0.015;
constexpr double second_moment = std::numbers::pi / 4.0 * 0.015 * 0.015 * 0.015 * 0.015;

}  // namespace

TEST_CASE("A chamber bends an arm to the circle of p A d = EI κ and does the work p dV", "[deck]") {
    Simulation run(read(make_arm(left)));
    run.run();
    const double stretch = pressure * area / (modulus * cross_section);
    const double turn = pressure * area * offset / (modulus * second_moment) * length;  // of the tip
    CHECK(run["tip"]["rotation_vector"].vector()[1] == Approx(turn).epsilon(1e-9));
    const double radius = length * (1.0 + stretch) / turn;
    CHECK(run["tip"]["position"].vector()[0] == Approx(radius * std::sin(turn)).epsilon(1e-9));
    CHECK(run["tip"]["position"].vector()[2] == Approx(radius * (std::cos(turn) - 1.0)).epsilon(1e-9));
    // Its middle is longer than the arm by d times the turn of the tip. The pressure grows with the volume.
    const double longer = length * stretch + offset * turn;
    CHECK(run["chamber"]["tendon_length"].number() == Approx(length + longer).epsilon(1e-12));
    CHECK(run["chamber"]["tendon_tension"].number() == Approx(-pressure * area));
    CHECK(run.ledger().external_work == Approx(0.5 * pressure * area * longer).epsilon(1e-9));
    CHECK(run.ledger().strain_energy == Approx(0.5 * pressure * area * longer).epsilon(1e-9));
}

TEST_CASE("Gas that is shut in a chamber follows p V by a continuous signal", "[deck]") {
    // 2 bar, of which the air outside takes 1, let out within 0.2 s; p V of 0.03 l at 2 bar.
    const std::string closed =
        "[chamber.left]\non = \"arm\"\noffset = [0, 0.008]\narea = 1.5e-4\n"
        "pressure = \"(2e5*0.2/reach - 1e5)*min(5*t, 1)\"\n"
        "[signal.reach]\nmeasure = \"chamber.tendon_length\"\ncontinuous = true\nstart = 0.2\n";
    Simulation run(read(make_arm(closed, "kind = \"quasi-static\"\nend_time = 1\ntime_step = 0.1\n")));
    run.run();
    // p A (1/EA + d²/EI) L = ℓ − L, and p + 1e5 = 2e5 L/ℓ.
    const double softness =
        area * (1.0 / (modulus * cross_section) + offset * offset / (modulus * second_moment));
    const double b = 1.0 + 1e5 * softness;
    const double longer = 0.5 * (std::sqrt(b * b + 4.0 * softness * 1e5) - b);
    CHECK(run["chamber"]["tendon_length"].number() == Approx(length * (1.0 + longer)).epsilon(1e-6));
}

namespace {

const std::string filled = "[chamber.left]\non = \"arm\"\noffset = [0, 0.008]\narea = 1.5e-4\n";

// The arm with a chamber that a history shows: at its side, or, if the tip is pulled, along its line.
std::string fill_arm(const std::string& filling,
                     double pull = 0.0,
                     const std::string& analysis = "kind = \"static\"\nsteps = 4\n") {
    return replaced(make_arm((pull == 0.0 ? filled : replaced(filled, "0.008", "0")) + filling, analysis),
                    "\"tendon_tension\"]",
                    "\"tendon_tension\", \"volume\", \"pressure\"]") +
           fmt::format("[[load]]\nat = \"arm.end\"\nforce = [{}, 0, 0]\n", pull);
}

// Strain of the chamber's middle by a pressure in it, over the pressure.
constexpr double softness_inside = area / (modulus * cross_section);
constexpr double softness = softness_inside + area * offset * offset / (modulus * second_moment);

// Its strain where the gas of the pressure p0 above the ambient one, a pull and the arm balance.
double find_strain(double p0, double ambient, double exponent, double pull) {
    double low = -0.9, high = 10.0;
    for (int i = 0; i < 200; ++i) {
        const double x = 0.5 * (low + high);
        const double p = (ambient + p0) * std::pow(1.0 + x, -exponent) - ambient;
        const double strain =
            pull == 0.0 ? softness * p : softness_inside * p + pull / (modulus * cross_section);
        (strain > x ? low : high) = x;
    }
    return low;
}

}  // namespace

TEST_CASE("Gas in a chamber bends and stretches an arm to the balance of p Vⁿ", "[deck]") {
    constexpr double ambient = 1e5, V0 = area * length;
    const double exponent = GENERATE(1.0, 1.4);
    for (const double p0 : {0.0, 4e4, -3e4}) {
        for (const double pull : {0.0, 30.0}) {
            INFO(exponent << " " << p0 << " " << pull);
            Simulation run(read(fill_arm(
                fmt::format("gas = {{ pressure = {}, ambient = 1e5, exponent = {} }}\n", p0, exponent),
                pull)));
            run.run();
            const double x = find_strain(p0, ambient, exponent, pull);
            const double p = (ambient + p0) * std::pow(1.0 + x, -exponent) - ambient;
            CHECK(run["chamber"]["volume"].number() == Approx(V0 * (1.0 + x)).epsilon(1e-9));
            CHECK(run["chamber"]["pressure"].number() == Approx(p).epsilon(1e-9).margin(1e-4));
            CHECK(run["chamber"]["tendon_tension"].number() == Approx(-p * area).epsilon(1e-9).margin(1e-9));
            const double turn = pull == 0.0 ? p * area * offset / (modulus * second_moment) * length : 0.0;
            CHECK(run["tip"]["rotation_vector"].vector()[1] == Approx(turn).epsilon(1e-9).margin(1e-10));
        }
    }
}

TEST_CASE("The energy of gas is that of the work p dV", "[deck]") {
    // Filled to nothing above the ambient pressure, so that a pull does all work.
    constexpr double ambient = 1e5, V0 = area * length, pull = 30.0;
    const double exponent = GENERATE(1.0, 1.4);
    Simulation run(read(fill_arm(fmt::format("gas = {{ ambient = 1e5, exponent = {} }}\n", exponent),
                                 pull,
                                 "kind = \"static\"\nsteps = 64\n")));
    run.run();
    const double x = find_strain(0.0, ambient, exponent, pull);
    const double p = ambient * (std::pow(1.0 + x, -exponent) - 1.0);
    const double stretch = (pull + p * area) / (modulus * cross_section);
    const double of_rod = 0.5 * length * modulus * cross_section * stretch * stretch;
    const double of_gas = exponent == 1.0
                              ? -ambient * V0 * std::log(1.0 + x)
                              : ambient * V0 / (exponent - 1.0) * (std::pow(1.0 + x, 1.0 - exponent) - 1.0);
    const LedgerRow ledger = run.ledger();
    CHECK(ledger.strain_energy == Approx(of_rod + of_gas + ambient * V0 * x).epsilon(1e-8));
    CHECK(std::abs(ledger.energy_error) < 1e-5 * ledger.external_work);
    // What pumps the gas does work, too.
    Simulation pumped(read(
        fill_arm("gas = { pressure = \"4e4*t\", ambient = 1e5 }\n", 0.0, "kind = \"static\"\nsteps = 64\n")));
    pumped.run();
    CHECK(std::abs(pumped.ledger().energy_error) < 1e-4 * std::abs(pumped.ledger().external_work));
}

TEST_CASE("Gas swings an arm, and energy stays", "[deck]") {
    Simulation run(read(
        fill_arm(
            "gas = { ambient = 1e5, exponent = 1.4 }\n",
            0.0,
            "kind = \"dynamic\"\nend_time = 0.05\ntime_step = 1e-4\nintegrator = \"newmark-simplified\"\n") +
        "[[initial]]\non = \"arm\"\nvelocity = [\"2*x\", 0, 0]\n"));
    const double whole = run.ledger().kinetic_energy;
    run.run();
    CHECK(std::abs(run.ledger().energy_error) < 1e-3 * whole);
}

TEST_CASE("Gas that is pumped below nothing is an error", "[deck]") {
    Simulation run(read(fill_arm("gas = { pressure = \"-2e5*t\", ambient = 1e5 }\n")));
    CHECK_THROWS_WITH(run.run(), Catch::Contains("chamber.left.gas.pressure: with ambient it is"));
}

TEST_CASE("A volume in a chamber sets its pressure", "[deck]") {
    constexpr double V0 = area * length;
    Simulation run(read(fill_arm(fmt::format("volume = \"{}*(1 + 0.02*t)\"\n", V0))));
    run.run();
    CHECK(run["chamber"]["volume"].number() == Approx(1.02 * V0).epsilon(1e-12));
    CHECK(run["chamber"]["pressure"].number() == Approx(0.02 / softness).epsilon(1e-9));
    // A number is reached from the volume at t = 0.
    Simulation reached(read(fill_arm(fmt::format("volume = {}\n", 0.99 * V0))));
    reached.run();
    CHECK(reached["chamber"]["pressure"].number() == Approx(-0.01 / softness).epsilon(1e-9));
}

TEST_CASE("A chamber has the form of its pressure in time, factors and stages", "[deck]") {
    const std::string pulsed =
        "[chamber.left]\non = \"arm\"\noffset = [[0.25, 0.01, 0], [0.75, 0.02, 0.004]]\narea = 2\n"
        "pressure = \"7*t\"\nfactor = 3\n";
    const Tendon chamber = read(make_arm(pulsed)).model.tendons.at(0);
    CHECK(chamber.tension(0.5) == Approx(-21.0));
    CHECK(chamber.from == Approx(0.05));
    CHECK(chamber.path(0.1).at == Vec3(0.0, 0.015, 0.002));
    const Problem twice =
        read(make_arm("[tendon.other]\non = \"arm\"\noffset = [0, 0]\ntension = 1\n" + left));
    CHECK(twice.model.tendons.at(1).name == "left");
    CHECK(twice.model.tendons.at(1).tension(1.0) == Approx(-7.5));
}

TEST_CASE("Wrong chambers are faults", "[deck]") {
    const auto fault = [](const std::string& chamber) {
        try {
            read(make_arm(chamber));
        } catch (const DeckError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    using Catch::Matchers::Contains;
    CHECK_THAT(fault("[chamber.left]\non = \"arm\"\noffset = [0, 0]\narea = 0\npressure = 1\n"),
               Contains("chamber.left.area"));
    CHECK_THAT(fault("[chamber.left]\non = \"arn\"\noffset = [0, 0]\narea = 1\npressure = 1\n"),
               Contains("chamber.left.on") && Contains("arm"));
    CHECK_THAT(fault("[chamber.left]\non = \"arm\"\noffset = [0, 0]\narea = 1\n"), Contains("pressure"));
    CHECK_THAT(fault(left + "volume = 1\n"), Contains("volume") && Contains("pressure"));
    CHECK_THAT(fault(filled + "gas = { pressure = 1 }\n"), Contains("chamber.left.gas.ambient"));
    CHECK_THAT(fault(filled + "gas = { pressure = -2, ambient = 1 }\n"),
               Contains("pressure + ambient is -1, which is no gas"));
    CHECK_THAT(fault(filled + "volume = 1e-5\nfactor = 2\n"), Contains("of a volume has no meaning"));
    CHECK_THAT(fault(left + "from = 0.5\nto = 0.25\n"), Contains("from < to"));
    CHECK_THAT(fault("[tendon.left]\non = \"arm\"\noffset = [0, 0]\ntension = 1\n" + left),
               Contains("has this name too"));
    CHECK_THAT(fault("[chamber.left]\non = \"arm\"\noffset = [0, 0]\narea = 1\npressure = \"1/(t - 1)\"\n"),
               Contains("inf at t = 1"));
}

}  // namespace gxrod::test
