#include <cmath>

#include "deck/decks.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

// Modes, buckling and eigenvalues of structures on joints: those of the same structure without them where the
// joint leaves nothing free.
using namespace gxrod;
using namespace gxrod::tools;

namespace {

// A cantilever of two rods under an axial load, held together in their middle.
std::string column(const std::string& middle) {
    return R"([section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 1, EIy = 1, EIz = 2 }
inertia = { rhoA = 1, rhoJ = 3e-3, rhoIy = 1e-3, rhoIz = 2e-3 }
[rod.a]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
y_axis = [0, 1, 0]
elements = 4
order = 3
[rod.b]
section = "s"
line = { from = [1, 0, 0], to = [2, 0, 0] }
y_axis = [0, 1, 0]
elements = 4
order = 3
[[support]]
at = "a.start"
fix = "all"
[[load]]
at = "b.end"
force = [-0.5, 0, 0]
)" + middle +
           R"([[stage]]
name = "factors"
kind = "buckling"
count = 3
[[stage]]
name = "press"
kind = "static"
steps = 2
[[stage]]
name = "tones"
kind = "modes"
count = 6
[[stage]]
name = "values"
kind = "eigenvalues"
count = 6
)";
}

RunSummary run_column(const std::string& middle) {
    const RunSummary summary = run_problem(test::read(column(middle)));
    REQUIRE(summary.status == RunStatus::complete);
    REQUIRE(summary.shapes.size() == 3);
    return summary;
}

}  // namespace

TEST_CASE("A weld changes no modes, factors and eigenvalues", "[analyses][joints]") {
    const RunSummary whole = run_column("[[connect]]\npoints = [\"a.end\", \"b.start\"]\n");
    const RunSummary welded =
        run_column("[joint.weld]\ntype = \"weld\"\nbetween = [\"a.end\", \"b.start\"]\n");
    const auto& factors = std::get<BucklingRecord>(whole.shapes[0].record).factors;
    const auto& welded_factors = std::get<BucklingRecord>(welded.shapes[0].record).factors;
    REQUIRE(welded_factors.size() == factors.size());
    for (std::size_t i = 0; i < factors.size(); ++i)
        CHECK(welded_factors[i].factor == Approx(factors[i].factor).epsilon(1e-9));
    const auto& modes = std::get<ModesRecord>(whole.shapes[1].record);
    const auto& welded_modes = std::get<ModesRecord>(welded.shapes[1].record);
    REQUIRE(welded_modes.modes.size() == modes.modes.size());
    for (std::size_t i = 0; i < modes.modes.size(); ++i)
        CHECK(welded_modes.modes[i].omega == Approx(modes.modes[i].omega).epsilon(1e-9));
    const auto& values = std::get<EigenvaluesRecord>(whole.shapes[2].record);
    const auto& welded_values = std::get<EigenvaluesRecord>(welded.shapes[2].record);
    REQUIRE(welded_values.modes.size() == values.modes.size());
    for (std::size_t i = 0; i < values.modes.size(); ++i)
        CHECK(std::abs(welded_values.modes[i].lambda() - values.modes[i].lambda()) < 1e-8);
}

TEST_CASE("A sprung hinge lowers what bends it alone", "[analyses][joints]") {
    const RunSummary whole = run_column("[[connect]]\npoints = [\"a.end\", \"b.start\"]\n");
    const RunSummary hinged = run_column(
        "[joint.hinge]\ntype = \"hinge\"\nbetween = [\"a.end\", \"b.start\"]\naxis = [0, 0, 1]\n"
        "spring = { stiffness = 2 }\n");
    const auto& factors = std::get<BucklingRecord>(whole.shapes[0].record).factors;
    const auto& lowered = std::get<BucklingRecord>(hinged.shapes[0].record).factors;
    CHECK(lowered[0].factor == Approx(factors[0].factor).epsilon(1e-9));  // about y
    // About z, of two halves of length 1 on a spring k: tan 2q = 2k/(EI q), P = EI q², without what shear and
    // compression change.
    constexpr double EI = 2.0, k = 2.0;
    double low = 0.1, high = 0.78;
    while (high - low > 1e-12) {
        const double q = 0.5 * (low + high);
        (std::tan(2 * q) < 2 * k / (EI * q) ? low : high) = q;
    }
    CHECK(0.5 * lowered[1].factor == Approx(EI * low * low).epsilon(5e-4));
}

TEST_CASE("A support that a joint pulls at exerts what it would without the joint", "[analyses][joints]") {
    const auto find = [](const std::string& middle) {
        const RunSummary summary = run_problem(test::read(R"([section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 1, EIy = 1, EIz = 2 }
inertia = { rhoA = 1, rhoJ = 3e-3, rhoIy = 1e-3, rhoIz = 2e-3 }
[rod.short]
section = "s"
line = { from = [0, 0, 0], to = [0, 0, 0.5] }
y_axis = [0, 1, 0]
elements = 2
[rod.beam]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
y_axis = [0, 1, 0]
elements = 4
order = 3
[[support]]
at = "short.start"
fix = "all"
[[stage]]
name = "shake"
kind = "response"
omega = { values = [0.5, 3, 10] }
excite = [{ at = "beam.end", force = [1, 2, 3], moment = [0.1, 0, 0] }]
[[history]]
name = "root"
at = "short.start"
quantities = "reaction_force"
)" + middle));
        REQUIRE(summary.status == RunStatus::complete);
        return std::get<ResponseRecord>(summary.shapes.at(0).record);
    };
    const ResponseRecord whole = find("[[connect]]\npoints = [\"short.start\", \"beam.start\"]\n");
    const ResponseRecord welded =
        find("[joint.weld]\ntype = \"weld\"\nbetween = [\"short.start\", \"beam.start\"]\n");
    for (std::size_t i = 0; i < whole.responses.size(); ++i) {
        const Vec6 expected = whole.responses[i].reactions.real[0];
        REQUIRE(expected.norm() > 1.0);
        CHECK((welded.responses[i].reactions.real[0] - expected).norm() < 1e-7 * expected.norm());
    }
}

namespace {

// A wheel on a torsion spring, and a block that slides up with it along a link: one motion is free, where
// `shaft` leaves it.
std::string crank(const std::string& shaft) {
    return R"([body.wheel]
mass = 0.5
inertia = [1e-4, 1e-4, 2e-4]
at = [0, 0, 0]
[body.block]
mass = 0.4
inertia = [1e-4, 1e-4, 1e-4]
at = [0.03, 0.05, 0]
[joint.shaft]
type = "hinge"
between = ["ground", "wheel"]
axis = [0, 0, 1]
)" + shaft +
           R"([joint.guide]
type = "slider"
between = ["ground", "block"]
axis = [0, 1, 0]
[joint.link]
type = "distance"
between = ["wheel", "block"]
at_a = [0.03, 0, 0]
[[stage]]
name = "tones"
kind = "modes"
count = 3
[[stage]]
name = "values"
kind = "eigenvalues"
count = 6
)";
}

}  // namespace

TEST_CASE("Motions that joints hold are no shapes", "[analyses][joints]") {
    const RunSummary summary = run_problem(test::read(crank("spring = { stiffness = 3 }\n")));
    INFO(summary.reason);
    REQUIRE(summary.status == RunStatus::complete);
    // The link is upright, so the block goes with the end of the crank.
    const double omega = std::sqrt(3.0 / (2e-4 + 0.4 * 0.03 * 0.03));
    const auto& modes = std::get<ModesRecord>(summary.shapes.at(0).record);
    REQUIRE(modes.modes.size() == 1);
    CHECK(modes.modes[0].omega == Approx(omega).epsilon(1e-7));
    CHECK(modes.is_all);
    CHECK(modes.counted == modes.found);
    const auto& values = std::get<EigenvaluesRecord>(summary.shapes.at(1).record);
    CHECK(values.is_all);
    REQUIRE(values.modes.size() == 1);
    for (const Eigenmode& mode : values.modes) CHECK(std::abs(mode.omega) == Approx(omega).epsilon(1e-6));

    const RunSummary held = run_problem(test::read(crank("move = \"0.1*t\"\n")));
    CHECK(held.status == RunStatus::failed);
    CHECK_THAT(held.reason, Catch::Contains("joints and supports hold all that has inertia"));
}
