// Runs of rods with tendons, strains of their own and a rest that is not their start.
#include <cmath>
#include <numbers>

#include "analyses/shapes/buckling.hpp"
#include "deck/decks.hpp"
#include "run/stepped_run.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

namespace gxrod::test {
namespace {

// A cantilever 2 long along x, of order 2.
std::string cantilever(const std::string& rest) {
    return R"deck([section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 8
order = 2
[[support]]
at = "r.start"
fix = "all"
)deck" + rest;
}

struct End {
    Vec3 tip;
    double strain_energy, external_work, energy_error;
};

End run(const std::string& deck) {
    const Problem problem = read(deck);
    SteppedRun simulation(RunRequest{problem});
    REQUIRE(simulation.start());
    double energy_error = 0.0;
    while (simulation.step())
        energy_error = std::max(energy_error, std::abs(simulation.analysis().ledger_row().energy_error));
    REQUIRE(simulation.summary().reason.empty());
    const LedgerRow row = simulation.analysis().ledger_row();
    return {simulation.analysis().state().trial.back().r, row.strain_energy, row.external_work, energy_error};
}

const std::string statics = "[analysis]\nkind = \"static\"\nsteps = 4\nnewton = { tolerance = 1e-12 }\n";

// Where a rod of the constant strains (Γ, K) ends: of the helix from the origin along x.
Vec3 find_end(double stretch, const Vec3& K, double length) {
    Vec3 end = Vec3::Zero();
    constexpr int pieces = 4000;
    const double ds = length / pieces;
    for (int i = 0; i < pieces; ++i) {
        const Vec3 turn = (i + 0.5) * ds * K;
        end += ds * stretch * (Eigen::AngleAxisd(turn.norm(), turn.normalized()) * Vec3::UnitX());
    }
    return end;
}

}  // namespace

TEST_CASE("a free rod takes the strains that drive it, without stress", "[analyses]") {
    for (const std::string element : {"objective", "simo"}) {
        const std::string deck =
            replaced(cantilever("[[actuation]]\non = \"r\"\nstretch = 0.05\ncurvature = [1.5, 0.4, -0.9]\n"),
                     "order = 2",
                     "order = 4\nelement = \"" + element + "\"") +
            statics;
        const End end = run(deck);
        CHECK((end.tip - find_end(1.05, Vec3(1.5, 0.4, -0.9), 2.0)).norm() < 1e-6);
        CHECK(std::abs(end.strain_energy) < 1e-12);
        CHECK(std::abs(end.external_work) < 1e-10);
    }
}

TEST_CASE("a rod between walls that a curvature drives stays straight and carries the moment", "[analyses]") {
    const End end = run(cantilever("[[support]]\nat = \"r.end\"\nfix = \"all\"\n"
                                   "[[actuation]]\non = \"r\"\ncurvature = [0, 0.3, 0]\n") +
                        statics);
    CHECK((end.tip - Vec3(2.0, 0.0, 0.0)).norm() < 1e-12);
    CHECK(end.strain_energy == Approx(0.5 * 6.0 * 0.3 * 0.3 * 2.0).epsilon(1e-12));
    // All of it the work of what drives the rod.
    CHECK(end.external_work == Approx(end.strain_energy).epsilon(1e-12));
}

TEST_CASE("a tendon beside a rod bends it to a circle", "[analyses]") {
    constexpr double T = 40.0, a = 0.05;
    const End end =
        run(cantilever("[tendon.t]\non = \"r\"\noffset = [0, 0.05]\ntension = \"40*t\"\n") + statics);
    const double kappa = -T * a / 6.0;  // about y
    CHECK((end.tip - find_end(1.0 - T / 1e4, Vec3(0.0, kappa, 0.0), 2.0)).norm() < 1e-6);
    CHECK(end.energy_error < 1e-10);
}

TEST_CASE("the books of rods that are driven balance to the order of the step", "[analyses]") {
    const std::string drives =
        "[tendon.t]\non = \"r\"\noffset = [\"0.05*cos(s)\", 0.05]\ntension = \"20*sin(3*t)^2\"\n"
        "[[actuation]]\non = \"r\"\ncurvature = [\"0.3*sin(t)\", 0, \"0.2*s*sin(2*t)\"]\n";
    for (const std::string scheme : {"newmark-simplified", "generalized-alpha", "sdirk-4"}) {
        const auto deck = [&](const std::string& step) {
            return cantilever(drives) + "[analysis]\nkind = \"dynamic\"\nend_time = 1\nintegrator = \"" +
                   scheme + "\"\ntime_step = " + step + "\nnewton = { tolerance = 1e-12 }\n";
        };
        CAPTURE(scheme);
        const End coarse = run(deck("0.02")), fine = run(deck("0.005"));
        CHECK(fine.energy_error < coarse.energy_error / 8.0);
        CHECK(fine.energy_error < 1e-3 * fine.strain_energy);
    }
}

namespace {

// A slender column along x, clamped at its start.
std::string column(const std::string& rest) {
    return R"deck([section.s]
stiffness = { EA = 1e7, GAy = 1e7, GAz = 1e7, GJ = 1, EIy = 2, EIz = 1 }
expansion = 1e-3
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 4
y_axis = [0, 1, 0]
[[support]]
at = "r.start"
fix = "all"
)deck" + rest +
           "[analysis]\nkind = \"buckling\"\ncount = 2\n";
}

const std::string held_end = "[[support]]\nat = \"r.end\"\nfix = \"all\"\n";
const std::string pushed_end = "[[load]]\nat = \"r.end\"\nforce = [-1, 0, 0]\n";

BucklingRecord find_factors(const std::string& deck) {
    const Problem problem = read(deck);
    const System system(problem.model);
    return find_buckling(system, system.initial_state(), 1.0, BucklingSettings{.count = 2});
}

}  // namespace

TEST_CASE("linear buckling refuses what would be left out of its load", "[analyses]") {
    const std::string law = "law = { moment_curvature = { table = [[0, 0], [1, 1], [2, 1.5]] } }\n[rod.r]";
    const std::string bent = "[[actuation]]\non = \"r\"\nstretch = 0.001\n";
    CHECK_THAT(find_factors(replaced(column(bent + pushed_end), "[rod.r]", law)).failure,
               Catch::Contains("would leave out what actuation[0] does to sections with a law"));
    const std::string rough = "[tendon.pull]\non = \"r\"\noffset = [0, 0.01]\ntension = 1\nfriction = 0.1\n";
    CHECK_THAT(find_factors(column(rough)).failure,
               Catch::Contains("would leave out how the friction of tendon.pull changes its tension"));
}

TEST_CASE("a column that is warmed between fixed ends buckles at EA a T = 4 pi^2 EI/L^2", "[analyses]") {
    const BucklingRecord record =
        find_factors(column(held_end + "[[actuation]]\non = \"r\"\ntemperature = 1e-3\n"));
    REQUIRE(record.failure.empty());
    const double euler = 4.0 * std::numbers::pi * std::numbers::pi / (1e7 * 1e-3 * 1e-3);
    REQUIRE(record.factors.size() == 2);
    CHECK(record.factors[0].factor == Approx(euler).epsilon(1e-5));
    CHECK(record.factors[1].factor == Approx(2.0 * euler).epsilon(2e-5));
    CHECK(record.is_complete);
    const BucklingRecord stretched =
        find_factors(column(held_end + "[[actuation]]\non = \"r\"\nstretch = 1e-6\n"));
    CHECK(stretched.factors.at(0).factor == Approx(euler).epsilon(1e-5));
}

TEST_CASE("a chamber under pressure buckles between fixed ends as a column does", "[analyses]") {
    const BucklingRecord record = find_factors(
        column(held_end + "[tendon.chamber]\non = \"r\"\noffset = [0, 0]\ntension = \"-2*t\"\n"));
    REQUIRE(record.failure.empty());
    REQUIRE(record.factors.size() == 2);
    CHECK(record.factors[0].factor == Approx(2.0 * std::numbers::pi * std::numbers::pi).epsilon(1e-5));
}

TEST_CASE("a tendon that follows a column does not buckle it", "[analyses]") {
    const std::string tendon = "[tendon.pull]\non = \"r\"\noffset = [0, 0]\ntension = 5\n";
    const BucklingRecord alone = find_factors(column(pushed_end));
    CHECK(alone.factors.at(0).factor == Approx(std::numbers::pi * std::numbers::pi / 4.0).epsilon(1e-5));
    const BucklingRecord pulled = find_factors(column(pushed_end + tendon));
    REQUIRE(pulled.failure.empty());
    // The tendon pulls on sheared sections as a shear stiffness of T does: by T/GA = 5e-7.
    CHECK(pulled.factors.at(0).factor == Approx(alone.factors[0].factor).epsilon(2e-6));
    const BucklingRecord tendon_alone = find_factors(column(tendon));
    CHECK(tendon_alone.is_complete);
    CHECK(tendon_alone.factors.empty());
    CHECK(tendon_alone.reversed.empty());
}

TEST_CASE("a winch that lets a rod out against a spring buckles it", "[analyses]") {
    constexpr double spring = 1e4, let_out = 1e-4, EA = 1e7;
    const std::string guided =
        "[[support]]\nat = \"r.end\"\nfix = [\"y\", \"z\", \"rotation\"]\n"
        "[bushing.stop]\nbetween = [\"ground\", \"r.end\"]\nat = [1, 0, 0]\nstiffness = { x = 1e4 }\n"
        "[tendon.winch]\non = \"r\"\noffset = [0, 0]\nshortening = \"-1e-4*t\"\nslack = false\n";
    const double euler = 4.0 * std::numbers::pi * std::numbers::pi;
    const BucklingRecord record = find_factors(column(guided));
    REQUIRE(record.failure.empty());
    CHECK(record.factors.at(0).factor == Approx(euler / (spring * let_out)).epsilon(1e-4));
    for (const double stiffness : {1e5, 1e6, 1e8}) {
        const BucklingRecord elastic =
            find_factors(column(guided + "stiffness = " + std::to_string(stiffness) + "\n"));
        REQUIRE(elastic.failure.empty());
        const double way = stiffness * let_out / (stiffness + EA + spring);
        CHECK(elastic.factors.at(0).factor == Approx(euler / (spring * way)).epsilon(1e-4));
    }
}

TEST_CASE("a winch whose tendon would push has no factors", "[analyses]") {
    const std::string guided =
        "[[support]]\nat = \"r.end\"\nfix = [\"y\", \"z\", \"rotation\"]\n"
        "[bushing.stop]\nbetween = [\"ground\", \"r.end\"]\nat = [1, 0, 0]\nstiffness = { x = 1e4 }\n"
        "[tendon.winch]\non = \"r\"\noffset = [0, 0]\nshortening = \"-1e-4*t\"\n";
    CHECK_THAT(find_factors(column(guided)).failure,
               Catch::Contains("tendon.winch goes slack before the first factor"));
}

TEST_CASE("a cable through the foot of a column belongs to the state, a load grows", "[analyses]") {
    const auto press = [](double tension) {
        const std::string deck =
            column(replaced(pushed_end, "-1, 0, 0", "-1e-3, 0, 0") +
                   "[spring.cable]\nbetween = [\"ground\", \"r.end\"]\nat_a = [0, 0, 0]\nforce = " +
                   std::to_string(tension) + "\n");
        const std::string analysis = "[analysis]\nkind = \"buckling\"\ncount = 2\n";
        return read(replaced(deck,
                             analysis,
                             "[[stage]]\nname = \"press\"\nkind = \"static\"\nsteps = 2\n"
                             "[[stage]]\nname = \"more\"\nkind = \"buckling\"\n"));
    };
    for (const double tension : {0.0, 5.0, 9.0, 9.77}) {
        INFO(tension);
        // The tip is pulled back by T w/L and pressed by P and T: k^3 cos k + T (sin k - k cos k) = 0 with
        // k^2 = P + T and EI = L = 1. Without P it is pi, without T pi/2.
        const auto unbalance = [&](double load) {
            const double k = std::sqrt(load + tension);
            return k * k * k * std::cos(k) + tension * (std::sin(k) - k * std::cos(k));
        };
        double low = 1e-6, high = 2.5;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            ((unbalance(low) < 0.0) == (unbalance(middle) < 0.0) ? low : high) = middle;
        }
        const RunSummary summary = tools::run_problem(press(tension));
        REQUIRE(summary.shapes.size() == 1);
        const auto& found = std::get<BucklingRecord>(summary.shapes[0].record);
        REQUIRE(!found.factors.empty());
        CHECK(1e-3 * (1.0 + found.factors[0].factor) == Approx(low).epsilon(1e-4));
    }
}

TEST_CASE("a strip closed to a ring carries EI/R, and unrolls when it is let go", "[analyses]") {
    const std::string ring = R"deck([section.s]
stiffness = { EA = 1e5, GAy = 4e4, GAz = 4e4, GJ = 0.8, EIy = 1, EIz = 1 }
[rod.r]
section = "s"
arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = [1, 0, 0], angle = "pi" }
elements = 16
order = 2
y_axis = [0, 0, 1]
rest = { curvature = [0, 0, 0] }
[[support]]
at = "r.start"
fix = "all"
)deck";
    for (const std::string element : {"objective", "simo"}) {
        const std::string deck = replaced(ring, "order = 2", "order = 2\nelement = \"" + element + "\"");
        const End held = run(deck + "[[support]]\nat = \"r.end\"\nfix = \"all\"\n" + statics);
        CHECK(held.strain_energy == Approx(0.5 * std::numbers::pi).epsilon(1e-6));
        const End free = run(deck + replaced(statics, "steps = 4", "steps = 20"));
        CHECK((free.tip - Vec3(1.0, std::numbers::pi, 0.0)).norm() < 1e-4);
        CHECK(free.strain_energy < 1e-12);
    }
}

}  // namespace gxrod::test
