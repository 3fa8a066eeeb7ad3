// Arches whose paths have bifurcations, against shooting and spectral elements. The whole rows are hidden:
// run them by "[paths]".
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "deck/problem.hpp"
#include "tools/path_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

struct Arch {
    double half_angle;
    double EA, GA, EI;
    const char* fix;
    int elements = 16;
};

// Radius 100, in the x-y plane, stiff out of it; a dead load of 1000 t down at the crown.
Model make_arch(const Arch& arch) {
    const std::string deck = fmt::format(R"DECK(
[parameters]
half = {:.17g}
[section.strip]
stiffness = {{ EA = {}, GAy = {}, GAz = {}, GJ = {}, EIy = {}, EIz = {} }}
[rod.arch]
section = "strip"
arc = {{ centre = [0, 0, 0], axis = [0, 0, 1], from = ["100*sin(half)", "100*cos(half)", 0], angle = "2*half" }}
elements = {}
order = 4
[[support]]
at = "arch.start"
fix = {}
[[support]]
at = "arch.end"
fix = {}
[[load]]
at = "arch@0.5"
force = [0, "-1000*t", 0]
[analysis]
kind = "static"
steps = 10
)DECK",
                                         arch.half_angle,
                                         arch.EA,
                                         arch.GA,
                                         arch.GA,
                                         1000.0 * arch.EI,
                                         arch.EI,
                                         1000.0 * arch.EI,
                                         arch.elements,
                                         arch.fix,
                                         arch.fix);
    return read_problem_text(deck, "arch.toml").model;
}

int find_crown(const Model& model) { return static_cast<int>(model.nodes.size()) / 2; }

PathSettings make_path_settings(double greatest_load, int crown, const std::vector<double>& down) {
    PathSettings settings;
    settings.newton.tolerance = 1e-10;
    settings.greatest_load = greatest_load;
    PathTarget target{crown, 1, {}};
    for (const double value : down) target.values.push_back(-value);
    settings.at = {target};
    return settings;
}

// Loads in units of the deck's force.
void check_loads(const PathRun& run,
                 const std::vector<std::pair<double, double>>& expected,
                 double tolerance) {
    for (const auto& [down, load] : expected) {
        CAPTURE(down);
        CHECK(1000.0 * run.find(1, -down).load == Approx(load).epsilon(tolerance));
    }
}

const Arch shallow{0.2, 1e7, 4e6, 9e5, "\"all\""};
const Arch slender{0.2, 1e7, 4e6, 1e5, "\"all\""};
const Arch deep{215.0 * std::numbers::pi / 360.0, 1e8, 1e8, 1e6, "[\"x\", \"y\", \"z\", \"rx\", \"ry\"]"};

}  // namespace

TEST_CASE("a shallow arch snaps through between two limit points", "[analyses]") {
    const Model model = make_arch(shallow);
    const int crown = find_crown(model);
    const PathRun run = run_path(model, make_path_settings(18.0, crown, {0.5, 1.0, 1.5, 2.0, 3.0}), crown);
    check_loads(run,
                {{0.5, 3551.188541},
                 {1.0, 4612.761390377},
                 {1.5, 4513.510880306},
                 {2.0, 4229.507930623},
                 {3.0, 6443.224358589}},
                2e-9);
    REQUIRE(run.points.size() == 2);
    CHECK(1000.0 * run.points[0].load_factor == Approx(4654.701499098).epsilon(2e-9));
    CHECK(run.at_points[0].moved[1] == Approx(-1.1519291607).epsilon(1e-7));
    CHECK(1000.0 * run.points[1].load_factor == Approx(4221.651082180).epsilon(2e-9));
    CHECK(run.at_points[1].moved[1] == Approx(-2.0743913985).epsilon(1e-7));
    CHECK(run.points[0].pivots_after == 1);
    CHECK(run.points[1].pivots_after == 0);
}

TEST_CASE("a slender arch has two bifurcations between its limit points", "[analyses]") {
    const Model model = make_arch(slender);
    const int crown = find_crown(model);
    const PathRun run = run_path(model, make_path_settings(0.75, crown, {2.0}), crown);
    REQUIRE(run.points.size() == 4);
    const std::array<CriticalKind, 4> kinds{
        CriticalKind::limit, CriticalKind::bifurcation, CriticalKind::bifurcation, CriticalKind::limit};
    const std::array<double, 4> loads{703.121428357, 527.0679957, 480.3392595, 296.606033647};
    const std::array<double, 4> down{0.7067768902, 1.48871611, 1.63124782, 2.4668111050};
    const std::array<std::int64_t, 4> after{1, 2, 1, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        CAPTURE(i);
        CHECK(run.points[i].kind == kinds[i]);
        CHECK(1000.0 * run.points[i].load_factor == Approx(loads[i]).epsilon(1e-7));
        CHECK(-run.at_points[i].moved[1] == Approx(down[i]).epsilon(2e-7));
        CHECK(run.points[i].pivots_after == after[i]);
    }
    CHECK(run.branches.size() == 4);
}

TEST_CASE("the branch of a slender arch is a loop that ends where it began", "[.][paths]") {
    const Model model = make_arch(slender);
    const int crown = find_crown(model);
    PathSettings settings = make_path_settings(0.75, crown, {});
    const PathRun main = run_path(model, settings, crown);
    REQUIRE(main.branches.size() == 4);
    settings.steps = 200;
    const PathRun branch = run_path(model, settings, crown, &main.branches[0]);
    CHECK(branch.steps < 100);
    REQUIRE(branch.points.size() == 2);
    CHECK(1000.0 * branch.points[0].load_factor == Approx(480.3392595).epsilon(1e-6));
    CHECK(1000.0 * branch.points[1].load_factor == Approx(527.0679957).epsilon(1e-6));
}

TEST_CASE("a deep arch sways before its limit load, to both sides", "[.][paths]") {
    Arch fine = deep;
    fine.elements = 24;
    const Model model = make_arch(fine);
    const int crown = find_crown(model);
    PathSettings settings = make_path_settings(0.95, crown, {10.0, 20.0, 40.0, 60.0});
    settings.points = 2;
    const PathRun main = run_path(model, settings, crown);
    check_loads(main,
                {{10.0, 221.308431420}, {20.0, 373.057419992}, {40.0, 585.266924585}, {60.0, 739.124185509}},
                2e-9);
    REQUIRE(main.points.size() == 2);
    CHECK(1000.0 * main.points[0].load_factor == Approx(327.6277845).epsilon(2e-7));
    CHECK(main.points[0].branching == Branching::supercritical);
    CHECK(1000.0 * main.points[1].load_factor == Approx(946.3035197).epsilon(2e-9));
    CHECK(-main.at_points[1].moved[1] == Approx(111.8773012).epsilon(5e-8));
    CHECK(main.points[1].pivots_after == 2);
    REQUIRE(main.branches.size() == 2);
    settings = make_path_settings(0.95, crown, {20.0, 40.0, 60.0, 80.0});
    settings.points = 1;
    std::vector<double> aside;
    for (const BranchStart& start : main.branches) {
        const PathRun branch = run_path(model, settings, crown, &start);
        check_loads(
            branch,
            {{20.0, 331.860966168}, {40.0, 358.853666185}, {60.0, 386.938136064}, {80.0, 408.882676423}},
            1e-8);
        CHECK(std::abs(branch.find(1, -40.0).moved[0]) == Approx(56.542023390).epsilon(1e-8));
        aside.push_back(branch.find(1, -40.0).moved[0]);
        REQUIRE(branch.points.size() == 1);
        CHECK(1000.0 * branch.points[0].load_factor == Approx(411.0760129733).epsilon(1e-8));
    }
    CHECK(aside[0] * aside[1] < 0.0);
}

TEST_CASE("a cantilever buckles sideways, to either side", "[analyses]") {
    const Model model = read_problem_text(R"(
[section.strip]
stiffness = { EA = 1e5, GAy = 4e4, GAz = 4e4, GJ = 1, EIy = 1, EIz = 50 }
[rod.r]
section = "strip"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 12
order = 4
y_axis = [0, 1, 0]
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, "-t", 0]
[analysis]
kind = "static"
steps = 10
)",
                                          "cantilever.toml")
                            .model;
    const int tip = static_cast<int>(model.nodes.size()) - 1;
    PathSettings settings = make_path_settings(8.0, tip, {});
    settings.at = {{-1, 0, {4.3, 5.0, 6.0}}};
    const PathRun main = run_path(model, settings, tip);
    REQUIRE(main.points.size() == 1);
    CHECK(main.points[0].load_factor == Approx(4.109165976173).epsilon(1e-8));
    CHECK(main.points[0].branching == Branching::supercritical);
    REQUIRE(main.branches.size() == 2);
    const std::array<std::pair<double, Vec3>, 4> expected{
        {{4.3, {0.9686280961, -0.0703311761099, 0.1986429506}},
         {5.0, {0.8740948726, -0.1957600743, 0.3582314930}},
         {6.0, {0.7747609840, -0.3179728066, 0.4200293463}},
         {8.0, {0.6453732641, -0.4614680358, 0.4292897181}}}};
    double sides = 1.0;
    for (const BranchStart& start : main.branches) {
        const PathRun branch = run_path(model, settings, tip, &start);
        for (const auto& [load, place] : expected) {
            const auto at = std::find_if(branch.places.begin(), branch.places.end(), [&](const auto& found) {
                return std::abs(found.load - load) < 1e-13;
            });
            REQUIRE(at != branch.places.end());
            CHECK(at->pivots == 0);
            CHECK(std::abs(1.0 + at->moved[0] - place[0]) < 1e-8);
            CHECK(std::abs(at->moved[1] - place[1]) < 1e-8);
            CHECK(std::abs(std::abs(at->moved[2]) - place[2]) < 1e-8);
        }
        sides *= branch.places.back().moved[2];
    }
    CHECK(sides < 0.0);
}

TEST_CASE("a hexagonal frame has double bifurcations, whose kernels are reported", "[.][paths]") {
    std::string deck = R"(
[section.s]
stiffness = { EA = 217.2612, GAy = 78.546, GAz = 78.546, GJ = 5.2629, EIy = 8.796, EIz = 8.796 }
)";
    const auto joint = [](int k) {
        const double angle = (k % 6) * std::numbers::pi / 3.0;
        return fmt::format("[{:.17g}, {:.17g}, 0]", 24.0 * std::cos(angle), 24.0 * std::sin(angle));
    };
    std::string apex;
    for (int k = 0; k < 6; ++k) {
        constexpr const char* mesh = "section = \"s\"\nelements = 4\norder = 4\n";
        deck += fmt::format("[rod.a{}]\n{}line = {{ from = [0, 0, 1.75], to = {} }}\n", k, mesh, joint(k));
        deck +=
            fmt::format("[rod.b{}]\n{}line = {{ from = {}, to = {} }}\n", k, mesh, joint(k), joint(k + 1));
        apex += fmt::format("\"a{}.start\", ", k);
    }
    deck += fmt::format("[[connect]]\npoints = [{}]\n", apex);
    for (int k = 0; k < 6; ++k) {
        deck += fmt::format(
            "[[connect]]\npoints = [\"a{}.end\", \"b{}.start\", \"b{}.end\"]\n", k, k, (k + 5) % 6);
        deck += fmt::format("[[support]]\nat = \"a{}.end\"\nfix = [{}\"z\"]\n", k, k == 0 ? "\"y\", " : "");
    }
    deck += R"([[support]]
at = "a0.start"
fix = ["x", "y"]
[[load]]
at = "a0.start"
force = [0, 0, "-t"]
[analysis]
kind = "static"
steps = 10
)";
    const Model model = read_problem_text(deck, "frame.toml").model;
    PathSettings settings = make_path_settings(0.21, 0, {});
    settings.at = {{0, 2, {-0.25, -0.5, -1.0, -1.5, -2.0, -2.5, -3.0, -4.0}}};
    const PathRun run = run_path(model, settings, 0);
    const std::array<double, 5> loads{0.0568914500, 0.0497001833, 0.0198032099, 0.0073995161, 0.1962087144};
    const std::array<double, 5> down{0.7652244148, 1.1072665, 1.7881805, 2.3648587, 4.4758682};
    const std::array<std::int64_t, 5> after{1, 3, 1, 0, 1};
    REQUIRE(run.points.size() == 5);
    for (std::size_t i = 0; i < 5; ++i) {
        CAPTURE(i);
        const bool is_double = i == 1 || i == 2;
        CHECK(run.points[i].load_factor == Approx(loads[i]).epsilon(1e-6));
        CHECK(-run.at_points[i].moved[2] == Approx(down[i]).epsilon(1e-6));
        CHECK(run.points[i].pivots_after == after[i]);
        CHECK(run.points[i].multiplicity == (is_double ? 2 : 1));
        CHECK(run.points[i].kernel.size() == (is_double ? 2 : 1));
    }
    for (const auto& [at, load] : std::vector<std::pair<double, double>>{{0.25, 0.0327347386},
                                                                         {0.5, 0.0509924525},
                                                                         {1.0, 0.0532602083},
                                                                         {3.0, 0.0278159223},
                                                                         {4.0, 0.1364594063}})
        CHECK(run.find(2, -at).load == Approx(load).epsilon(1e-6));
}
