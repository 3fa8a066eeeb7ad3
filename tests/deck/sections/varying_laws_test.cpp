#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "deck/decks.hpp"
#include "face/gxrod.hpp"
#include "laws/layered_law.hpp"
#include "laws/mixed_law.hpp"
#include "laws/plastic_law.hpp"
#include "laws/trapeze_law.hpp"
#include "run/stepped_run.hpp"
#include "tools/catch.hpp"

// Sections with laws that vary along a rod, or that are given about another point.
namespace gxrod::test {
namespace {

// A cantilever of 2 along x, of sections a and b, which is pulled.
const std::string pulled = R"deck([section.a]
stiffness = { EA = 200, GAy = 80, GAz = 80, GJ = 5, EIy = 6, EIz = 7 }
law = { plastic = { yield = { N = 40 }, kinematic = 1 } }
[section.b]
stiffness = { EA = 100, GAy = 40, GAz = 40, GJ = 2, EIy = 3, EIz = 4 }
law = { plastic = { yield = { N = 10 }, kinematic = 1 } }
[rod.r]
sections = [[0, "a"], [1, "b"]]
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 10
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

struct Reached {
    NodeMotion tip;
    Vec6 root;  // forces of the support
};

Reached reach_end(const std::string& deck) {
    const Problem problem = read(deck);
    RunRequest request{problem};
    SteppedRun simulation(request);
    while (simulation.step()) {
    }
    REQUIRE(simulation.summary().reason.empty());
    const Snapshot snapshot = simulation.take_snapshot();
    return {snapshot.nodes[static_cast<std::size_t>(problem.model.rods[0].nodes.back())],
            snapshot.reactions[0]};
}

template <class Law>
const Law& law_at(const Problem& problem, std::size_t point) {
    const auto* law = dynamic_cast<const Law*>(problem.model.rods[0].varying.at_forces.at(point).law.get());
    REQUIRE(law != nullptr);
    return *law;
}

}  // namespace

// Section b yields everywhere, section a from 0.4 on: both sides of a node.
TEST_CASE("Between stations a rod has both sections with their laws", "[deck][sections]") {
    const auto both = [](double t) { return t / 30.0 - (70.0 / 3.0) / 150.0 * std::log(200.0 - 150.0 * t); };
    const auto all = [](double t) { return -0.3 * t - 0.8 * std::log(50.0 - 50.0 * t + 50.0); };
    const double elongation = 2.0 * (both(0.4) - both(0.0) + all(1.0) - all(0.4));
    CHECK(reach_end(pulled).tip.r.x() == Approx(2.0 + elongation).epsilon(1e-9));
    const Problem problem = read(pulled);
    const auto& law = law_at<MixedLaw>(problem, 0);
    CHECK(law.shares()[0].share + law.shares()[1].share == 1.0);
    CHECK(dynamic_cast<const PlasticLaw*>(law.shares()[1].law.get()) != nullptr);
    CHECK(problem.model.sections.back().law != nullptr);
}

TEST_CASE("At a jump of sections each side has its own law", "[deck][sections]") {
    const std::string jump =
        replaced(pulled, R"([[0, "a"], [1, "b"]])", R"([[0, "a"], [0.3, "a"], [0.3, "b"], [1, "b"]])");
    // 30/200, and 0.1 + 20/50.
    CHECK(reach_end(jump).tip.r.x() == Approx(2.0 + 0.6 * 0.15 + 1.4 * 0.5).epsilon(1e-12));
    const std::string linear =
        replaced(jump, "law = { plastic = { yield = { N = 40 }, kinematic = 1 } }", "");
    CHECK(reach_end(linear).tip.r.x() == Approx(2.0 + 0.6 * 0.15 + 1.4 * 0.5).epsilon(1e-12));
}

TEST_CASE("Within an element laws can remember different amounts", "[deck][sections]") {
    const std::string mixed =
        replaced(pulled, R"([[0, "a"], [1, "b"]])", R"([[0, "c"], [0.55, "b"], [1, "a"]])") +
        "[section.c]\nstiffness = { EA = 200, GAy = 80, GAz = 80, GJ = 5, EIy = 6, EIz = 7 }\n"
        "law = { layers = [{ on = \"bending\", stiffness = 4, limit = 1 }, { on = \"torsion\", stiffness = "
        "4, limit = 1 }] }\n";
    const Problem problem = read(mixed);
    CHECK(law_at<MixedLaw>(problem, 20).memory_size() != law_at<MixedLaw>(problem, 23).memory_size());
    CHECK(reach_end(mixed).root[0] == Approx(-30.0).epsilon(1e-10));
}

TEST_CASE("Numbers of laws can be functions of s", "[deck][sections]") {
    const std::string s = replaced(replaced(pulled, R"(sections = [[0, "a"], [1, "b"]])", "section = \"a\""),
                                   "yield = { N = 40 }",
                                   "yield = { N = \"20 - 4*s\" }");
    // ε = N₀/EA + (30 − N₀)/(EA/2).
    CHECK(reach_end(s).tip.r.x() == Approx(2.0 + 2.0 * 0.3 - (40.0 - 8.0) / 200.0).epsilon(1e-12));
    const std::string layers = replaced(s,
                                        "plastic = { yield = { N = \"20 - 4*s\" }, kinematic = 1 }",
                                        "layers = [{ on = \"tension\", stiffness = \"100 + s\", limit = "
                                        "\"10 - s\" }]");
    // Beyond its limit the layer pulls by it: ε = (30 − 10 + s)/200.
    CHECK(reach_end(layers).tip.r.x() == Approx(2.0 + (40.0 + 2.0) / 200.0).epsilon(1e-12));
    CHECK(law_at<LayeredLaw>(read(layers), 39).layers()[0].limit == Approx(8.0).margin(0.02));
    CHECK(faults_of(replaced(layers, "10 - s", "1 - s")).find("layers[0].limit: expected a number") !=
          std::string::npos);
}

// The plastic moment falls as (1 − 0.8 x)², the moment of the force as 1 − x: the hinge is at x = 3/4. It has
// turned by 0.04, which shortens the arm of the force by 0.08 %.
TEST_CASE("A cantilever that tapers collapses at the load of its weakest section", "[deck][sections]") {
    const std::string deck = R"deck(plane = "xz"
[section.taper]
shape = { rectangle = { width_y = 0.02, height_z = "0.05*(1 - 0.8*s)" } }
material = { E = 2e11, nu = 0.3, density = 1, yield_stress = 2e7 }
[rod.r]
section = "taper"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 60
order = 2
[[support]]
at = "r.start"
fix = "all"
[[support]]
at = "r.end"
move = { z = "-0.01*t" }
[analysis]
kind = "static"
steps = 60
)deck";
    const double most = 0.64 * 2e7 * 0.02 * 0.05 * 0.05 / 4.0;
    CHECK(reach_end(deck).root[2] == Approx(most).epsilon(1e-3));
    // At first yield the whole rod is elastic: the same as without a yield stress.
    const std::string before = replaced(deck, "-0.01*t", "-0.0005*t");
    const double elastic = reach_end(replaced(before, ", yield_stress = 2e7", "")).root[2];
    CHECK(elastic < 2.0 / 3.0 * most);
    CHECK(reach_end(before).root[2] == Approx(elastic).epsilon(1e-11));
}

// Strains that are held relax everywhere alike, and the shape stays.
TEST_CASE("A rod that tapers relaxes by its elastic forces", "[deck][sections]") {
    const std::string elastic = R"deck([section.taper]
stiffness = { EA = "1000 - 500*s", GAy = 500, GAz = "500 - 300*s", GJ = 1, EIy = "1 - 0.7*s", EIz = 2 }
[rod.r]
section = "taper"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 8
order = 3
[[support]]
at = "r.start"
fix = "all"
[[support]]
at = "r.end"
move = { z = "1e-5*min(t, 1)" }
[analysis]
kind = "quasi-static"
end_time = 3
steps = 30
newton = { tolerance = 1e-13 }
)deck";
    const std::string relaxing =
        replaced(elastic, "[rod.r]", "law = { viscoelastic = { prony = [[0.5, 0.7]] } }\n[rod.r]");
    const double factor = 1.0 + 0.5 * 0.7 * (1.0 - std::exp(-1.0 / 0.7)) * std::exp(-2.0 / 0.7);
    CHECK(reach_end(relaxing).root[2] / reach_end(elastic).root[2] == Approx(factor).epsilon(1e-8));
}

TEST_CASE("A law that never yields leaves a rod that varies as it is", "[deck][sections]") {
    const std::string bent = replaced(replaced(pulled, "[30, 0, 0]", "[0, 1, 2]"), "N = 40", "N = 4e9");
    const std::string law = replaced(bent, "N = 10", "N = 1e9");
    std::string linear = replaced(law, "law = { plastic = { yield = { N = 4e9 }, kinematic = 1 } }", "");
    linear = replaced(linear, "law = { plastic = { yield = { N = 1e9 }, kinematic = 1 } }", "");
    const Reached one = reach_end(law), other = reach_end(linear);
    CHECK((one.tip.r - other.tip.r).norm() < 1e-12);
    CHECK((one.root - other.root).norm() < 1e-11);
}

// A moment is the same about any point. Bending yields at 8 and hardens; the axes of the section are turned.
TEST_CASE("A law given about another point bends the rod as it does there", "[deck][sections]") {
    const std::string deck = R"deck([section.s]
stiffness = { EA = 200, GAy = 80, GAz = 80, GJ = 50, EIy = 60, EIz = 90 }
law = { plastic = { yield = { My = 8 }, kinematic = 0.5 } }
AT
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
y_axis = AXIS
elements = 6
order = 2
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
moment = [0, 12, 0]
frame = "spatial"
[analysis]
kind = "static"
steps = 3
newton = { tolerance = 1e-12 }
)deck";
    const Quat own = reach_end(replaced(replaced(deck, "AT\n", "\n"), "AXIS", "[0, 1, 0]")).tip.Lambda;
    const std::string moved = replaced(deck, "AT\n", "at = [0.1, 0.2]\nturn = 0.4\n");
    const Quat about_point =
        reach_end(replaced(moved, "AXIS", "[0, \"cos(0.4)\", \"-sin(0.4)\"]")).tip.Lambda;
    CHECK(own.angularDistance(about_point) < 1e-10);
    // κ = 8/60 + 4/20.
    CHECK(own.angularDistance(Quat::Identity()) == Approx(2.0 * (8.0 / 60.0 + 4.0 / 20.0)).epsilon(1e-10));
}

TEST_CASE("The trapeze's term varies with the stiffness, about the rod", "[deck][sections]") {
    const std::string deck =
        replaced(replaced(pulled, R"(sections = [[0, "a"], [1, "b"]])", "section = \"a\""),
                 "EIy = 6, EIz = 7 }\nlaw = { plastic = { yield = { N = 40 }, kinematic = 1 } }",
                 "EIy = \"6 - s\", EIz = 7 }\nat = [0.1, 0]\ntrapeze = true");
    const Problem problem = read(deck);
    // EIz + EA y².
    CHECK(law_at<TrapezeLaw>(problem, 0).coefficient() == Approx(13.0 + 2.0).margin(0.02));
    CHECK(law_at<TrapezeLaw>(problem, 39).coefficient() == Approx(11.0 + 2.0).margin(0.02));
}

// ε = N₀/EA + (30 − N₀)/(EA/2) with N₀ = Y − 4 s; and for b alone, between stations, by differences.
TEST_CASE("Derivatives by numbers of laws that vary are those of the states", "[deck][sections]") {
    const std::string history =
        "[[history]]\nname = \"tip\"\nat = \"r.end\"\nquantities = [\"position\"]\n[parameters]\nY = 20\n";
    const auto differentiate = [](const std::string& text) {
        const Deck deck = Deck::from_text(text);
        std::vector<VariedNumber> variations;
        variations.push_back(vary(deck, "Y"));
        Simulation run(deck.build(), {.sensitivities = std::move(variations)});
        run.run();
        return run["tip"].derivative("Y").position.vector().x();
    };
    const std::string s = replaced(replaced(pulled, R"(sections = [[0, "a"], [1, "b"]])", "section = \"a\""),
                                   "yield = { N = 40 }",
                                   "yield = { N = \"Y - 4*s\" }");
    CHECK(differentiate(s + history) == Approx(-2.0 / 200.0).epsilon(1e-8));
    const std::string stations = replaced(pulled, "yield = { N = 10 }", "yield = { N = \"Y/2\" }") + history;
    const auto end_of = [&](const std::string& Y) {
        return reach_end(replaced(stations, "Y = 20", "Y = " + Y)).tip.r.x();
    };
    const double difference = (end_of("20.001") - end_of("19.999")) / 0.002;
    CHECK(differentiate(stations) == Approx(difference).epsilon(1e-5));
}

}  // namespace gxrod::test
