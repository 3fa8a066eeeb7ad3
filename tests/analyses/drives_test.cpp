// Runs of rods with tendons, strains of their own and a rest that is not their start.
#include <cmath>
#include <numbers>

#include "analyses/shapes/buckling.hpp"
#include "deck/decks.hpp"
#include "run/stepped_run.hpp"
#include "tools/catch.hpp"

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

TEST_CASE("linear buckling refuses what would be left out of its load", "[analyses]") {
    const Problem problem = read(
        cantilever(
            "[[actuation]]\non = \"r\"\nstretch = 0.001\n[[load]]\nat = \"r.end\"\nforce = [-1, 0, 0]\n") +
        statics);
    const System system(problem.model);
    const BucklingRecord record = find_buckling(system, system.initial_state(), 1.0, BucklingSettings{});
    CHECK_THAT(record.failure, Catch::Contains("would leave out what actuation[0] does"));
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
