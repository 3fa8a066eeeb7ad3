// Paths that meet obstacles and rods, and leave them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "analyses/contact/contact_run.hpp"
#include "analyses/path/path.hpp"
#include "deck/decks.hpp"
#include "model/problem.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::read;

namespace {

// Follows the path of a deck, step by step.
class ContactPath {
  public:
    explicit ContactPath(const std::string& deck)
        : problem_(read(deck)), path_(problem_.model, std::get<PathSettings>(problem_.analysis())) {
        REQUIRE(path_.start().converged());
    }
    void step() {
        const EquilibriumReport report = path_.advance();
        INFO("at λ = " << load() << " after " << path_.steps().steps_done() << " steps");
        REQUIRE(report.converged());
    }
    void finish() {
        while (!path_.finished()) step();
    }
    bool is_finished() const { return path_.finished(); }
    double load() const { return path_.row().load_factor; }
    double load_rate() const { return path_.row().load_rate; }
    const std::vector<CriticalPoint>& points() const { return path_.critical_points(); }
    const PathAnalysis& path() const { return path_; }
    Vec3 displacement(const std::string& node) const {
        const auto& nodes = problem_.model.nodes;
        const auto found = std::ranges::find(nodes, node, &Node::name);
        REQUIRE(found != nodes.end());
        return path_.state().trial[static_cast<std::size_t>(found - nodes.begin())].r - found->position;
    }
    std::vector<CriticalKind> kinds() const {
        std::vector<CriticalKind> list;
        for (const CriticalPoint& point : points()) list.push_back(point.kind);
        return list;
    }

  private:
    Problem problem_;
    PathAnalysis path_;
};

const std::string stiff =
    "[section.s]\nstiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 1, EIy = 1, EIz = 1 }\n"
    "radius = 0.01\n";

// A cantilever that is pressed in its middle, and a ball below its tip.
std::string propped(double load, const std::string& analysis) {
    return stiff + R"([rod.beam]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 3
[[support]]
at = "beam.start"
fix = "all"
[[load]]
at = "beam@0.5"
)" + fmt::format("force = [0, 0, {}]\n", -load) +
           R"([obstacle.ball]
sphere = { centre = [1, 0, -0.112], radius = 0.1 }
)" + analysis;
}

const std::string to_one =
    "[analysis]\nkind = \"path\"\nuntil = { t = 1, steps = 400 }\nnewton = { tolerance = 1e-11 }\n";

// Two cantilevers that cross, one of which is pressed on the other.
const std::string crossing = R"(
[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e9, nu = 0.3, density = 1000 }
[rod.a]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 3
[rod.b]
section = "s"
line = { from = [0.7, -0.6, -0.06], to = [0.7, 0.4, -0.06] }
elements = 8
order = 3
[[support]]
at = "a.start"
fix = "all"
[[support]]
at = "b.start"
fix = "all"
[[load]]
at = "a.end"
force = [0, 0.2, -6]
)";

// Half of a shallow arch, whose crown is pushed down, over a floor.
const std::string arch_over_floor = R"(
[section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 1, EIy = 1, EIz = 1 }
radius = 0.01
[rod.arch]
section = "s"
spline = [[-1, 0, 0], [-0.5, 0, 0.075], [0, 0, 0.1]]
elements = 6
order = 3
[[support]]
at = "arch.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "arch.end"
fix = ["x", "y", "rotation"]
[[load]]
at = "arch.end"
force = [0, 0, -60]
[obstacle.floor]
plane = { point = [0, 0, -0.06], normal = [0, 0, 1] }
[analysis]
kind = "path"
until = { t = 1, steps = 400 }
max_step = 0.02
newton = { tolerance = 1e-11 }
)";

}  // namespace

TEST_CASE(
    "A path meets a stop where a cantilever reaches it, and goes on with the stiffness of a propped one",
    "[analyses][touch][paths]") {
    ContactPath run(propped(0.1, to_one));
    double load_before = 0.0, before = 0.0, soft = 0.0, hard = 0.0;
    while (!run.is_finished()) {
        run.step();
        const double down = -run.displacement("beam@0.5").z();
        const double slope = (down - before) / (0.1 * (run.load() - load_before));
        if (run.points().empty() && soft == 0.0) soft = slope;
        hard = slope;
        before = down;
        load_before = run.load();
    }
    CHECK(run.load() == Approx(1.0).epsilon(1e-9));
    CHECK(soft == Approx(1.0 / 24.0).epsilon(1e-4));
    CHECK(hard == Approx(7.0 / 768.0).epsilon(5e-3));
    REQUIRE(run.points().size() == 1);
    const CriticalPoint& point = run.points()[0];
    CHECK(point.kind == CriticalKind::touch);
    CHECK(point.is_located);
    CHECK(point.shape == "rod beam and obstacle ball");
    // The tip is 5 P/48 down, and the gap of 2e-3 is that less the skin of 2e-4.
    CHECK(0.1 * point.load_factor == Approx(48.0 / 5.0 * 1.8e-3).epsilon(1e-4));
    CHECK(point.pivots_before == 0);
    CHECK(point.pivots_after == 0);
}

TEST_CASE("A path with contact ends where load steps end", "[analyses][touch][paths]") {
    const std::string statics = "[analysis]\nkind = \"static\"\nsteps = 10\nnewton = { tolerance = 1e-11 }\n";
    test::ContactRun steps(propped(3.0, statics));
    steps.finish();
    ContactPath path(propped(3.0, to_one));
    path.finish();
    const Vec3 down = steps.at("beam@0.5").r - Vec3(0.5, 0, 0);
    CHECK((path.displacement("beam@0.5") - down).norm() < 1e-8 * down.norm());
    for (const char* friction : {"", "friction = 0.3\n"}) {
        test::ContactRun pressed(crossing + "[contact]\n" + friction + statics);
        pressed.finish();
        ContactPath pair(crossing + "[contact]\n" + friction + to_one);
        pair.finish();
        REQUIRE(pair.points().size() == 1);
        CHECK(pair.points()[0].kind == CriticalKind::touch);
        CHECK(pair.points()[0].shape == "rod a and rod b");
        const Vec3 moved = pressed.at("a.end").r - Vec3(1, 0, 0);
        // Friction has other steps, and changes little.
        CHECK((pair.displacement("a.end") - moved).norm() < (*friction == '\0' ? 1e-8 : 0.02) * moved.norm());
    }
}

TEST_CASE("An arch that snaps through turns back on the floor", "[analyses][touch][paths]") {
    ContactPath run(arch_over_floor);
    run.finish();
    CHECK(run.load() == Approx(1.0).epsilon(1e-9));
    const auto& points = run.points();
    REQUIRE(run.kinds() == std::vector{CriticalKind::limit, CriticalKind::touch, CriticalKind::limit});
    CHECK(points[0].pivots_after == 1);
    CHECK(points[1].pivots_after == 1);
    CHECK(points[2].pivots_after == 0);
    CHECK(points[1].load_factor < points[0].load_factor);
    // The lowest node is a radius and the skin above the floor, which turns the load back at once.
    double lowest = 1.0;
    for (const NodeMotion& node : points[1].nodes) lowest = std::min(lowest, node.r.z());
    CHECK(lowest == Approx(-0.06 + 0.01 + 2e-4).margin(1e-8));
    CHECK(points[2].load_factor == Approx(points[1].load_factor).epsilon(1e-3));
    // What the load does is stored in the arch and in contact.
    CHECK(std::abs(run.path().ledger_row().energy_error) < 1e-3 * run.path().ledger_row().external_work);
}

TEST_CASE("Contact that ends on a path is found too", "[analyses][touch][paths]") {
    const std::string lift = propped(0.1, "") +
                             "[[stage]]\nname = \"press\"\nkind = \"path\"\nuntil = { t = 1, steps = 400 }\n"
                             "[[stage]]\nname = \"lift\"\nkind = \"path\"\nuntil = { t = 1, steps = 400 }\n"
                             "[[load]]\nat = \"beam.end\"\nforce = [0, 0, \"0.06*t\"]\nstages = \"lift\"\n";
    const RunSummary summary = run_problem(read(lift));
    INFO(summary.reason);
    REQUIRE(summary.status == RunStatus::complete);
    std::string all;
    for (const auto& line : summary.notes) all += line + "\n";
    for (const auto& line : summary.findings) all += line + "\n";
    CHECK_THAT(all, Catch::Contains("press: contact begins at") && Catch::Contains("lift: contact ends at"));
}
