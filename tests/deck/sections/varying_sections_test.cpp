#include <cmath>

#include "deck/decks.hpp"
#include "run/stepped_run.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A cantilever of 2 along x, of sections a and b, which is pulled.
const std::string bar = R"deck([section.a]
stiffness = { EA = 200, GAy = 80, GAz = 80, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 3, rhoIy = 0.1, rhoIz = 0.2 }
[section.b]
stiffness = { EA = 100, GAy = 40, GAz = 40, GJ = 2, EIy = 3, EIz = 4 }
inertia = { rhoA = 1, rhoIy = 0.1, rhoIz = 0.2 }
[rod.r]
sections = [[0, "a"], [1, "b"]]
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
order = 4
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [30, 0, 0]
[analysis]
kind = "static"
newton = { tolerance = 1e-13 }
)deck";

// A cone of 1 along x, bent in the plane of x and z: docs/verification/tapered_cantilever.md.
const std::string taper = R"deck(plane = "xz"
[section.cone]
shape = { circle = { radius = "0.02 - 0.01*s" } }
material = { E = 2e9, G = 0.8e9, shear_factor = 0.9, density = 9e5 }
[rod.r]
section = "cone"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 4
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, 0, -150]
[analysis]
kind = "static"
steps = 4
newton = { tolerance = 1e-12 }
)deck";

struct Ended {
    Vec3 tip;
    Vec6 root;  // what the support exerts
};

Ended run(const std::string& deck) {
    const Problem problem = read(deck);
    RunRequest request{problem};
    SteppedRun simulation(request);
    while (simulation.step()) {
    }
    REQUIRE(simulation.summary().reason.empty());
    const Snapshot snapshot = simulation.take_snapshot();
    return {snapshot.nodes[static_cast<std::size_t>(problem.model.rods[0].nodes.back())].r,
            snapshot.reactions[0]};
}

}  // namespace

TEST_CASE("sections are linear between stations", "[deck][sections]") {
    const Ended ended = run(bar);
    // ∫ F ds/EA of EA = 200 − 50 s.
    CHECK(ended.tip.x() == Approx(2.0 + 30.0 * std::log(2.0) / 50.0).epsilon(1e-10));
    const Rod& rod = read(bar).model.rods[0];
    REQUIRE(rod.varying.at_nodes.size() == 20);
    CHECK(rod.varying.at_nodes.front().stiffness(0, 0) == 200.0);
    CHECK(rod.varying.at_nodes.back().mass(0, 0) == Approx(1.0));
    // The mean stands for the rod where one section has to.
    CHECK(read(bar).model.sections.at(2).mass(0, 0) == Approx(2.0).epsilon(1e-14));
    CHECK(read(bar).model.sections.at(2).name == "a … b along r");
}

TEST_CASE("a station that stands twice is a jump, with a node", "[deck][sections]") {
    const std::string deck =
        replaced(replaced(bar, R"([[0, "a"], [1, "b"]])", R"([[0, "a"], [0.3, "a"], [0.3, "b"], [1, "b"]])"),
                 "elements = 4",
                 "elements = 3");
    CHECK(run(deck).tip.x() == Approx(2.0 + 30.0 * (0.6 / 200.0 + 1.4 / 100.0)).epsilon(1e-13));
    const Model model = read(deck).model;
    CHECK(model.nodes.at(4).position.x() == Approx(0.6).epsilon(1e-14));
    CHECK(model.rods[0].varying.at_nodes.at(4).stiffness(0, 0) == 200.0);
    CHECK(model.rods[0].varying.at_nodes.at(5).stiffness(0, 0) == 100.0);
}

TEST_CASE("what varies along a rod weighs as it should", "[deck][sections]") {
    const Ended ended = run(replaced(bar, "[section.a]", "gravity = [0, 0, -10]\n[section.a]"));
    CHECK(ended.root[2] == Approx(10.0 * 4.0).epsilon(1e-12));
}

TEST_CASE("numbers of sections are functions of the arc length", "[deck][sections]") {
    const Ended cone = run(taper);
    CHECK((cone.tip - Vec3(0.918880778280, 0.0, -0.332821348524)).norm() < 1e-9);
    const std::string heavy = replaced(
        replaced(
            replaced(taper, "0.02 - 0.01*s", "0.02 - 0.014*s"), "force = [0, 0, -150]", "force = [0, 0, 0]"),
        "plane = \"xz\"",
        "plane = \"xz\"\ngravity = [0, 0, -1]");
    const Ended sagging = run(heavy);
    CHECK((sagging.tip - Vec3(0.949589458890, 0.0, -0.279563137084)).norm() < 1e-8);
    CHECK(std::abs(sagging.root[4]) == Approx(172.639188653).epsilon(1e-7));
}

TEST_CASE("twist follows fractions of the length", "[deck][sections]") {
    const Model model =
        read(replaced(bar,
                      "order = 4",
                      "order = 1\ntwist = [[0, 0.3], [0.5, 0.1], [1, -0.4]]\ny_axis = [0, 1, 0]"))
            .model;
    const auto twist = [&](std::size_t entry) {
        const Vec3 y = model.rods[0].triads.at(entry) * Vec3::UnitY();
        return std::atan2(y.z(), y.y());
    };
    CHECK(twist(0) == Approx(0.3));
    CHECK(twist(1) == Approx(0.2));
    CHECK(twist(3) == Approx(0.1));
    CHECK(twist(5) == Approx(-0.15));
    CHECK(twist(7) == Approx(-0.4));
}

TEST_CASE("what is wrong with sections along a rod is said", "[deck][sections]") {
    const auto with = [](const std::string& stations) {
        return replaced(bar, R"([[0, "a"], [1, "b"]])", stations);
    };
    CHECK_THROWS_WITH(read(with(R"([[0, "a"], [1, "c"]])")), Contains("no section \"c\"; the deck has a, b"));
    CHECK_THROWS_WITH(read(with(R"([[0.1, "a"], [1, "b"]])")),
                      Contains("expected the fraction 0 here, found 0.1"));
    CHECK_THROWS_WITH(read(with(R"([[0, "a"], [0.5, "b"], [0.4, "a"], [1, "b"]])")),
                      Contains("0.4 follows 0.5"));
    CHECK_THROWS_WITH(read(with(R"([[0, "a"]])")), Contains("two at least, from 0 to 1"));
    CHECK_THROWS_WITH(read(with(R"([[0, "a"], [1, 2]])")), Contains("the name of a section"));
    CHECK_THROWS_WITH(read(replaced(bar, "sections =", "section = \"a\"\nsections =")),
                      Contains("only one of them"));
    CHECK_THROWS_WITH(read(replaced(bar, "[section.b]", "[section.b]\ndamping = { kelvin_voigt = 0.1 }")),
                      Contains("the same damping in all sections of a rod"));
    CHECK_THROWS_WITH(read(replaced(taper, "0.02 - 0.01*s", "0.02 - 0.03*s")),
                      Contains("expected a number greater than 0, found") && Contains("of rod.r"));
    const std::string net = "mesh = { file = \"" GXROD_SOURCE_DIR "/meshes/truss.geo\", group = \"truss\" }";
    CHECK_THROWS_WITH(read(replaced(replaced(taper, "line = { from = [0, 0, 0], to = [1, 0, 0] }", net),
                                    "elements = 8\norder = 4\n",
                                    "")),
                      Contains("a rod from a mesh has one section"));
    CHECK_THROWS_WITH(read(replaced(taper, "0.02 - 0.01*s", "0.02 - 0.01*t")),
                      Contains("is a function of s"));
    CHECK_THROWS_WITH(read(replaced(taper, "0.02 - 0.01*s", "0.02/(1 - s)")), Contains("s = 1"));
    CHECK_THROWS_WITH(read(replaced(bar, "order = 4", "order = 1\ntwist = [[0, 1], [0.9, 2]]")),
                      Contains("expected the fraction 1 here, found 0.9"));
}

}  // namespace gxrod::test
