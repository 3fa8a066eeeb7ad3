// Rods whose sections have laws, against closed forms: plastic collapse loads, damped vibration.
#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "analyses/shapes/modes.hpp"
#include "analyses/static.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

constexpr double L = 2.0, Mp = 1.0;

// A beam of the length 2, clamped at its start, that bears the moment 1; its other end can slide along. Short
// pieces at the clamps and about a place between take the hinges. Until the place has sunk so far that all
// turn.
std::string beam(double hinge, double stub, const std::string& end, const std::string& load) {
    const auto piece = [](const char* name, double from, double to, bool yields) {
        return fmt::format(
            "[rod.{}]\nsection = \"{}\"\nline = {{ from = [{}, 0, 0], to = [{}, 0, 0] }}\n"
            "elements = {}\norder = {}\ny_axis = [0, 1, 0]\n",
            name,
            yields ? "yields" : "elastic",
            from,
            to,
            yields ? 1 : 4,
            yields ? 1 : 2);
    };
    const std::string stiffness =
        "stiffness = { EA = 1e7, GAy = 4e6, GAz = 4e6, GJ = 1e4, EIy = 1e4, EIz = 1e4 }\n";
    return "plane = \"xz\"\n[section.yields]\n" + stiffness +
           "law = { plastic = { yield = { My = 1 } } }\n[section.elastic]\n" + stiffness +
           piece("a", 0.0, stub, true) + piece("b", stub, hinge - 0.5 * stub, false) +
           piece("c", hinge - 0.5 * stub, hinge + 0.5 * stub, true) +
           piece("d", hinge + 0.5 * stub, L - stub, false) + piece("e", L - stub, L, true) +
           "[[connect]]\npoints = [\"a.end\", \"b.start\"]\n[[connect]]\npoints = [\"b.end\", \"c.start\"]\n"
           "[[connect]]\npoints = [\"c.end\", \"d.start\"]\n[[connect]]\npoints = [\"d.end\", \"e.start\"]\n"
           "[[support]]\nat = \"a.start\"\nfix = \"all\"\n[[support]]\nat = \"e.end\"\nfix = " +
           end + "\n" + load +
           "[analysis]\nkind = \"path\"\nuntil = { steps = 1000 }\n"
           "control = { of = \"c.end\", displacement = \"z\", to = -4e-4 }\n"
           "max_step = 0.05\nnewton = { tolerance = 1e-10 }\n";
}

double find_last_load(const std::string& deck) {
    const Problem problem = read(deck);
    const auto analysis = make_analysis(problem.model, problem.analysis(), 1);
    REQUIRE(analysis->start().converged());
    while (!analysis->finished()) REQUIRE(analysis->advance().converged());
    return analysis->state().time;
}

// Without the error of first order in the length of the pieces that yield, which is small.
double find_collapse_load(double hinge, const std::string& end, const std::string& load) {
    const double coarse = find_last_load(beam(hinge, 2e-5, end, load));
    const double fine = find_last_load(beam(hinge, 1e-5, end, load));
    CHECK(coarse == Approx(fine).epsilon(2e-5));
    return 2.0 * fine - coarse;
}

const std::string held = "[\"y\", \"z\", \"rx\", \"ry\", \"rz\"]";
const std::string pinned = "[\"y\", \"z\", \"rx\"]";
const std::string weight = "[[load]]\nat = \"c.end\"\nforce = [0, 0, -1]\n";

// On all pieces.
std::string spread() {
    std::string loads;
    for (const char* name : {"a", "b", "c", "d", "e"})
        loads += fmt::format("[[load]]\non = \"{}\"\nforce_per_length = [0, 0, -1]\n", name);
    return loads;
}

// The root of s² + ω²(1 + Σ r τ s/(1 + τ s)) = 0 in the upper half plane, near i ω.
std::complex<double> find_root(double omega, const std::vector<std::pair<double, double>>& prony) {
    std::complex<double> s(0.0, omega);
    for (int i = 0; i < 200; ++i) {
        std::complex<double> factor = 1.0;
        for (const auto& [r, tau] : prony) factor += r * tau * s / (1.0 + tau * s);
        s = 0.5 * (s + std::complex<double>(0.0, omega) * std::sqrt(factor));
    }
    return s;
}

// The two neighbours of each value that a decaying vibration has: u₊ − 2 Re z u + |z|² u₋ = 0 with z = exp(s
// h).
std::complex<double> fit(const std::vector<double>& u, double h) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (std::size_t i = 1; i + 1 < u.size(); ++i) {
        const Eigen::Vector2d row(u[i], -u[i - 1]);
        normal += row * row.transpose();
        right += row * u[i + 1];
    }
    const Eigen::Vector2d found = normal.inverse() * right;
    const std::complex<double> z(0.5 * found[0], std::sqrt(found[1] - 0.25 * found[0] * found[0]));
    return std::log(z) / h;
}

// The steel cantilever M1, 1 long, with this law.
Problem make_steel_cantilever(const std::string& law, int steps) {
    return read(fmt::format(R"deck([section.s]
shape = {{ rectangle = {{ width_y = 0.05, height_z = 0.1 }} }}
material = {{ E = 2.1e11, nu = 0.3, density = 7850, shear_factor = "5/6" }}
{}
[rod.r]
section = "s"
line = {{ from = [0, 0, 0], to = [1, 0, 0] }}
elements = 3
order = 4
y_axis = [0, 1, 0]
[[support]]
at = "r.start"
fix = "all"
[analysis]
kind = "dynamic"
end_time = 0.16
steps = {}
newton = {{ tolerance = 1e-12 }}
)deck",
                            law,
                            steps));
}

// s of its free motion in its first mode, in so many steps.
std::complex<double> measure_decay(const std::string& prony, int steps) {
    constexpr double first = 0.08;  // from where the creeping part has died out
    const Problem elastic = make_steel_cantilever("", steps);
    const System system(elastic.model);
    const ModesRecord modes = find_modes(system, system.initial_state(), 0.0, {.count = 1});
    CHECK(modes.modes[0].omega == Approx(2.0 * std::numbers::pi * 41.6927962022).epsilon(1e-7));
    Problem problem = make_steel_cantilever("law = { viscoelastic = { prony = [" + prony + "] } }", steps);
    for (std::size_t i = 0; i < problem.model.nodes.size(); ++i) {
        // Small, so that the motion is linear.
        problem.model.nodes[i].velocity = 1e-4 * modes.modes[0].shape.nodes[i].head<3>();
        problem.model.nodes[i].angular_velocity = 1e-4 * modes.modes[0].shape.nodes[i].tail<3>();
    }
    const auto analysis = make_analysis(problem.model, problem.analysis(), 1);
    REQUIRE(analysis->start().converged());
    std::vector<double> tip;
    while (!analysis->finished()) {
        REQUIRE(analysis->advance().converged());
        if (analysis->state().time > first) tip.push_back(analysis->state().trial.back().r.y());
    }
    return fit(tip, 0.16 / steps);
}

}  // namespace

TEST_CASE("F11f: beams collapse at the loads of limit analysis", "[analyses]") {
    CHECK(find_collapse_load(0.5 * L, held, weight) == Approx(8.0 * Mp / L).epsilon(5e-7));
    CHECK(find_collapse_load(0.5 * L, held, spread()) == Approx(16.0 * Mp / (L * L)).epsilon(5e-7));
    CHECK(find_collapse_load(0.5 * L, pinned, weight) == Approx(6.0 * Mp / L).epsilon(5e-7));
    // The hinge is where no shear acts.
    CHECK(find_collapse_load((2.0 - std::sqrt(2.0)) * L, pinned, spread()) ==
          Approx(11.6568542494924 * Mp / (L * L)).epsilon(5e-7));
}

TEST_CASE("F13c: a rod that relaxes swings and dies out as its branches say", "[analyses]") {
    const double omega = 2.0 * std::numbers::pi * 41.6927962022;
    const std::vector<std::pair<double, double>> one{{0.2, 0.004}}, two{{0.2, 0.004}, {0.5, 0.05}};
    const std::complex<double> of_one(-12.940345998828, 276.37307325978),
        of_two(-13.275374621626, 334.60802284412);
    CHECK(std::abs(find_root(omega, one) - of_one) < 1e-8 * std::abs(of_one));
    CHECK(std::abs(find_root(omega, two) - of_two) < 1e-8 * std::abs(of_two));
    const std::complex<double> coarse = measure_decay("[0.2, 0.004]", 800);
    const std::complex<double> fine = measure_decay("[0.2, 0.004]", 1600);
    CHECK(std::abs(fine - of_one) < 2e-4 * std::abs(of_one));
    CHECK(std::abs(coarse - of_one) / std::abs(fine - of_one) == Approx(4.0).epsilon(0.02));
    // Without the error of second order of the steps.
    CHECK(std::abs((4.0 * fine - coarse) / 3.0 - of_one) < 2e-6 * std::abs(of_one));
}

}  // namespace gxrod::test
