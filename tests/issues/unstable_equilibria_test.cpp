#include <fmt/format.h>

#include "analyses/static.hpp"
#include "deck/decks.hpp"
#include "study/deck_study.hpp"
#include "study/deck_study_text.hpp"
#include "tools/catch.hpp"

// Equilibria that no structure would stay at came out as results without a word.

namespace gxrod::test {
namespace {

using Catch::Contains;

struct WatchedRun {
    std::vector<std::string> warnings;
    double critical = 0.0;    // the first load factor with a negative pivot; 0 without any
    std::int64_t pivots = 0;  // at the end
    State state;
};

WatchedRun run(const Problem& problem) {
    StaticAnalysis analysis(problem.model, std::get<StaticSettings>(problem.analysis()));
    REQUIRE(analysis.start().converged());
    WatchedRun watched;
    while (!analysis.finished()) {
        const EquilibriumReport report = analysis.advance();
        if (!report.converged()) FAIL(describe_failure(analysis.explain(report)));
        watched.pivots = analysis.solver_row().negative_pivots;
        if (watched.pivots > 0 && watched.critical == 0.0) watched.critical = analysis.state().time;
    }
    watched.warnings = analysis.list_warnings();
    watched.state = analysis.state();
    return watched;
}

Vec3 displacement_of(const Problem& problem, const WatchedRun& watched, int rod) {
    const auto node =
        static_cast<std::size_t>(problem.model.rods[static_cast<std::size_t>(rod)].nodes.back());
    return watched.state.trial[node].r - problem.model.nodes[node].position;
}

// Of a rod from the origin to (10, 0, 0), hardly to be stretched or sheared, four times as stiff about y as
// about z unless said otherwise.
std::string make_rod(const std::string& supports_and_loads,
                     const std::string& stiffness = "GJ = 300, EIy = 2000, EIz = 500") {
    return R"([section.s]
stiffness = { EA = 1e7, GAy = 1e7, GAz = 1e7, )" +
           stiffness + R"( }
inertia = { rhoA = 1.0 }
[rod.b]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
y_axis = [0, 1, 0]
elements = 16
order = 2
)" + supports_and_loads +
           R"([analysis]
kind = "static"
steps = 10
)";
}

const std::string clamped = "[[support]]\nat = \"b.start\"\nfix = \"all\"\n";

// Such a deck is one that the run speaks of, as soon as its load factor passes `critical`.
void check_warned(const std::string& deck, double critical, const std::string& shape) {
    const WatchedRun watched = run(read(deck));
    CHECK(watched.critical == Approx(critical).margin(0.1 / 256.0 + 2e-3 * critical));
    CHECK(watched.pivots > 0);
    REQUIRE(watched.warnings.size() >= 2);
    CHECK_THAT(watched.warnings.front(), Contains("became unstable") && Contains(shape));
    CHECK_THAT(watched.warnings.back(), Contains("the state at t = 1 is unstable"));
}

}  // namespace

TEST_CASE("A column with a little load sideways goes where the elastica is", "[issues]") {
    const Problem problem = read(make_rod(clamped + R"([[load]]
at = "b.end"
force = ["-1.5*pi^2*500/400", "1.5e-4*pi^2*500/400", 0]
)"));
    const WatchedRun watched = run(problem);
    CHECK(watched.warnings.empty());
    CHECK(displacement_of(problem, watched, 0).y() == Approx(7.886).margin(2e-3));
}

TEST_CASE("A joined wing stays on the branch that is stable, in ten steps", "[issues]") {
    const Problem problem = read(R"deck(title = "A joined wing (Blair), 70 kN at the joint"
[section.s0]
stiffness = { EA = 950534200.220524, GAy = 312833363.0525028, GAz = 46925004.45787542, GJ = 8659883.091578264, EIy = 6540864.048140759, EIz = 139524500.5022882 }
[rod.b0]
section = "s0"
line = { from = [-7.1726, -12.0, -3.21539], to = [-5.37945, -9.0, -2.41154] }
y_axis = [-0.8583563825621824, 0.5130539157971258, 0.0]
elements = 5
order = 3

[section.s1]
stiffness = { EA = 803425807.6437931, GAy = 264773010.09844258, GAz = 39715951.514766395, GJ = 5250418.720892991, EIy = 3921045.8213414685, EIz = 84284341.65500733 }
[rod.b1]
section = "s1"
line = { from = [-5.37945, -9.0, -2.41154], to = [-3.5863, -6.0, -1.6077] }
y_axis = [-0.8583563825621824, 0.5130539157971258, 0.0]
elements = 5
order = 3

[[connect]]
points = ["b0.end","b1.start"]

[section.s2]
stiffness = { EA = 621867343.2583362, GAy = 205455247.73793772, GAz = 30818350.478608985, GJ = 2453162.9856956066, EIy = 1793364.9085114894, EIz = 39110777.36581092 }
[rod.b2]
section = "s2"
line = { from = [-3.5863, -6.0, -1.6077], to = [-1.79315, -3.0, -0.803848] }
y_axis = [-0.8583563825621824, 0.5130539157971258, 0.0]
elements = 5
order = 3

[[connect]]
points = ["b1.end","b2.start"]

[section.s3]
stiffness = { EA = 389890908.52379507, GAy = 131500047.34001705, GAz = 17617761.52245648, GJ = 520369.8789099292, EIy = 347741.4194804743, EIz = 9735392.044237621 }
[rod.b3]
section = "s3"
line = { from = [-1.79315, -3.0, -0.803848], to = [0.0, 0.0, 0.0] }
y_axis = [-0.8583563825621824, 0.5130539157971258, 0.0]
elements = 5
order = 3

[[connect]]
points = ["b2.end","b3.start"]

[section.s4]
stiffness = { EA = 360499363.71862304, GAy = 131500047.34001705, GAz = 6575011.013143446, GJ = 78273.5975328162, EIy = 35925.992455541586, EIz = 7934870.582260803 }
[rod.b4]
section = "s4"
line = { from = [0.0, 0.0, 0.0], to = [7.1726, -12.0, 3.21539] }
y_axis = [0.8583563825621824, 0.5130539157971258, 0.0]
elements = 20
order = 3

[[connect]]
points = ["b3.end","b4.start"]

[[load]]
at = "b4.start"
force = [0,0,70000.0]
frame = "spatial"
[[support]]
at = "b0.start"
fix = "all"
[[support]]
at = "b4.end"
fix = "all"
[analysis]
kind = "static"
steps = 10
[[history]]
name = "joint"
at = "b4.start"
quantities = ["displacement","rotation_vector"]
)deck");
    const WatchedRun watched = run(problem);
    CHECK(watched.warnings.empty());
    const Vec3 expected(-2.457667495, -4.031143519, 6.649219683);
    CHECK((displacement_of(problem, watched, 3) - expected).norm() < 1e-6);
}

TEST_CASE("A straight column between two hinges buckles at π² EI / L²", "[issues]") {
    check_warned(make_rod(R"([[support]]
at = "b.start"
fix = ["x", "y", "z", "rx", "ry"]
[[support]]
at = "b.end"
fix = ["y", "z", "rx", "ry"]
[[load]]
at = "b.end"
force = ["-2*pi^2*500/100", 0, 0]
)"),
                 0.5,
                 "bending about z");
}

TEST_CASE("A column buckles under its own weight at 7.8373 EI / L³", "[issues]") {
    // Greenhill (1881).
    check_warned(make_rod(clamped + R"([[load]]
on = "b"
force_per_length = ["-2*7.8373474*500/1000", 0, 0]
)"),
                 0.5,
                 "bending about z");
}

TEST_CASE("A deep cantilever gives way sideways at 4.0126 √(EI GJ) / L²", "[issues]") {
    // Prandtl (1899); the load bends it about y, where it is a thousand times as stiff.
    check_warned(make_rod(clamped + R"([[load]]
at = "b.end"
force = [0, 0, "-2*4.0126*sqrt(500*300)/100"]
)",
                          "GJ = 300, EIy = 5e5, EIz = 500"),
                 0.5,
                 "rod b");
}

TEST_CASE("A study calls no series right that belongs to an unstable equilibrium", "[issues]") {
    DeckStudy study;
    study.runs.resize(1);
    study.is_static = true;
    study.series.resize(1);
    study.series[0].scale = 1.0;
    CHECK(study.is_accurate());
    study.runs[0].is_unstable = true;
    study.runs[0].warnings = {"the state at t = 1 is unstable"};
    CHECK_FALSE(study.is_accurate());
    CHECK_FALSE(study.is_stable());
    CHECK(to_json(study, false)["stable"] == false);
    const std::vector<std::string> sentences = judge(study);
    const std::string all = fmt::format("{}", fmt::join(sentences, "\n"));
    CHECK_THAT(all, Contains("No series is called right") && Contains("the state at t = 1 is unstable"));
    CHECK_THAT(all, !Contains("All series are right"));
}

}  // namespace gxrod::test
